import zoo from 'content:zoo'
import type { LoadedCage } from '@botgarten/content/catalogue'
import { language } from '#words/language.svelte.ts'

/** The words of a cage in the language of now; what is not translated yet is said in English. */
export const textOf = ({ text }: LoadedCage) => text[language.locale] ?? text['en']!

export const cages = zoo.cages

/** A number in the language of now, with its sign where stars are taken away. */
export const stars = (value: number, places = 0): string =>
  value.toLocaleString(language.locale, { maximumFractionDigits: places }).replace('-', '−')

/** Where it was published, in one line. */
export const sourceOf = ({ cage: { source } }: LoadedCage): string =>
  `${source.by}: ${source.title}. ${source.in}, ${source.year}`
