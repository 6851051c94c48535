import { language } from '#words/language.svelte.ts'

const formats = new Map<string, Intl.NumberFormat>()

/** A number in the language of now, with its groups of thousands. */
export function number(value: number, places = 0): string {
  const key = `${language.locale} ${places}`
  let format = formats.get(key)
  if (!format)
    formats.set(key, (format = new Intl.NumberFormat(language.locale, { maximumFractionDigits: places })))
  return format.format(value)
}
