import { language, type Locale } from '#words/language.svelte.ts'

/** Those of these that there are words in, in the order of the switch; without any the one that the page speaks. */
export function localesOf(names: readonly string[]): readonly Locale[] {
  const known = language.all.filter((locale) => names.includes(locale))
  return known.length > 0 ? known : [language.locale]
}

/** Languages that something is printed in: each by itself, or all of them. `value` as `?languages=` has it. */
export const languageChoices = () => {
  const upper = (locales: readonly Locale[]) => locales.map((locale) => locale.toUpperCase()).join(' + ')
  const named = (locales: readonly Locale[]) => locales.map((locale) => language.names[locale]).join(' + ')
  return [...language.all.map((locale) => [locale]), language.all].map((locales) => ({
    ...{ value: locales.join(','), words: upper(locales), name: named(locales) },
  }))
}
