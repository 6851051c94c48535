import { language } from '#words/language.svelte.ts'

/** A number as it is written in the language of now: `0,8`. */
export const decimal = (value: number): string =>
  value.toLocaleString(language.locale, { maximumFractionDigits: 2 })
