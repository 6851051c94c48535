import zoo from 'content:zoo'
import type { LoadedCage } from '@botgarten/content/catalogue'
import { writeNumber } from '@botgarten/messages'
import { language } from '#words/language.svelte.ts'

/** The words of a cage in the language of now; what is not translated yet is said in English. */
export const textOf = ({ text }: LoadedCage) => text[language.locale] ?? text['en']!

export const cages = zoo.cages

/** A number in the current language, with a minus sign where something is taken away. */
export const number = (value: number, places = 0): string =>
  writeNumber(value, language.locale, { most: places })

/** A reward with its sign: `+20`, `−5`, `0`. */
export const signed = (reward: number): string => writeNumber(reward, language.locale, { plus: true })

/** Where it was published, in one line. */
export const sourceOf = ({ cage: { source } }: LoadedCage): string =>
  `${source.by}: ${source.title}. ${source.in}, ${source.year}`
