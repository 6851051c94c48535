// What is wrong in a folder of messages, each in a line that names it: for the test over content/words, and for one who adds a language.
import { factsOf, placeholdersIn } from './facts.ts'
import { completeLanguages, filesIn, languagesIn, ownTableOf } from './folder.ts'
import type { Message } from './message.ts'

const keysIn = (file: string, folder?: string): readonly string[] => [
  ...new Set(languagesIn(folder).flatMap((language) => Object.keys(ownTableOf(file, language, folder)))),
]

/** Messages that a complete language lacks and any other has: "de lacks home.title (app.json)". */
export function missingIn(folder?: string): readonly string[] {
  return filesIn(folder).flatMap((file) => {
    const tables = completeLanguages.map(
      (language) => [language, ownTableOf(file, language, folder)] as const,
    )
    return keysIn(file, folder).flatMap((key) =>
      tables.flatMap(([language, table]) =>
        Object.hasOwn(table, key) ? [] : [`${language} lacks ${key} (${file}.json)`],
      ),
    )
  })
}

const isComplete = (language: string) => (completeLanguages as readonly string[]).includes(language)

/** How much there is of each language that need not be complete: "fr: 5 of 5816 messages (0 %)". */
export function sharesIn(folder?: string): readonly string[] {
  const countIn = (language: string) =>
    filesIn(folder).reduce((sum, file) => sum + Object.keys(ownTableOf(file, language, folder)).length, 0)
  const all = filesIn(folder).reduce((sum, file) => sum + keysIn(file, folder).length, 0)
  return languagesIn(folder)
    .filter((language) => !isComplete(language))
    .map((language) => {
      const count = countIn(language)
      return `${language}: ${count} of ${all} messages (${Math.floor((100 * count) / all)} %)`
    })
}

/** Messages that stand in two files of a language. */
export const doubledIn = (folder?: string): readonly string[] =>
  languagesIn(folder).flatMap((language) => {
    const keys = filesIn(folder).flatMap((file) => Object.keys(ownTableOf(file, language, folder)))
    return keys
      .filter((key, at) => keys.indexOf(key) < at)
      .map((key) => `${key} is there twice in ${language}`)
  })

/** Messages that need other facts in a language than in English. */
export function unlikeIn(folder?: string): readonly string[] {
  const [first] = completeLanguages
  const others = languagesIn(folder).filter((language) => language !== first)
  return filesIn(folder).flatMap((file) => {
    const table = ownTableOf(file, first, folder)
    return others.flatMap((language) =>
      Object.entries(ownTableOf(file, language, folder)).flatMap(([key, message]) => {
        const known = table[key]
        if (known === undefined || String(factsOf(known)) === String(factsOf(message))) return []
        return [
          `${key} has {${factsOf(known).join()}} in ${first} and {${factsOf(message).join()}} in ${language}`,
        ]
      }),
    )
  })
}

/** Sentences that change with a number and are not whole. */
export const wrongForms = (language: string, key: string, message: Message): readonly string[] => {
  if (typeof message === 'string') return []
  const { declarations, selectors, match } = message[0]
  const locals = declarations.flatMap((one) => /^local (\w+) = \w+: \w+$/.exec(one)?.[1] ?? [])
  const unknown = declarations.filter((one) => !/^(input \w+|local \w+ = \w+: (plural|number))$/.test(one))
  const undeclared = placeholdersIn(message).filter(
    (name) => !declarations.includes(`input ${name}`) && !locals.includes(name),
  )
  const categories = new Intl.PluralRules(language).resolvedOptions().pluralCategories
  const fits = (wanted: readonly string[]) =>
    Object.keys(match).some((selected) =>
      selected.split(',').every((one) => {
        const [name, value] = one.trim().split('=')
        return value === '*' || value === wanted[selectors.indexOf(name!)]
      }),
    )
  const asked = selectors.reduce<readonly (readonly string[])[]>(
    (all) => all.flatMap((one) => categories.map((category) => [...one, category])),
    [[]],
  )
  return [
    ...unknown.map((one) => `${key} in ${language}: "${one}" is not understood`),
    ...undeclared.map((name) => `${key} in ${language}: {${name}} is not declared`),
    ...selectors
      .filter((one) => !locals.includes(one) && !declarations.includes(`input ${one}`))
      .map((one) => `${key} in ${language}: ${one} is not declared`),
    ...asked.filter((one) => !fits(one)).map((one) => `${key} in ${language}: no form for ${one.join(', ')}`),
  ]
}
