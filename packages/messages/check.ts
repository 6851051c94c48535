// What is wrong in a folder of messages, each in a line that names it: for the test over content/words, and for one who adds a language.
import { factsOf, placeholdersIn } from './facts.ts'
import { filesIn, languagesIn, ownTableOf } from './folder.ts'
import type { Message } from './message.ts'

/** Messages that some language has and another has not: "xx lacks home.title (app.json)". */
export function missingIn(folder?: string): readonly string[] {
  const languages = languagesIn(folder)
  return filesIn(folder).flatMap((file) => {
    const tables = languages.map((language) => [language, ownTableOf(file, language, folder)] as const)
    const keys = [...new Set(tables.flatMap(([, table]) => Object.keys(table)))]
    return keys.flatMap((key) =>
      tables.flatMap(([language, table]) =>
        Object.hasOwn(table, key) ? [] : [`${language} lacks ${key} (${file}.json)`],
      ),
    )
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

/** Messages that want other facts in one language than in another. */
export function unlikeIn(folder?: string): readonly string[] {
  const [first, ...others] = languagesIn(folder)
  return filesIn(folder).flatMap((file) => {
    const table = ownTableOf(file, first!, folder)
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
