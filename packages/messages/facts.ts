import { formsOf, type Message } from './message.ts'
import type { Table } from './table.ts'

/** Names in the gaps of a message's forms. */
export const placeholdersIn = (message: Message): readonly string[] => [
  ...new Set(
    formsOf(message).flatMap((form) => [...form.matchAll(/(?<!\\)\{(\w+)\}/g)].map(([, name]) => name!)),
  ),
]

/** Facts that a message may be given: a form may leave one out, "Last day". */
export const factsOf = (message: Message): readonly string[] =>
  typeof message === 'string'
    ? placeholdersIn(message).toSorted()
    : message[0].declarations
        .flatMap((declaration) => /^input (\w+)$/.exec(declaration)?.[1] ?? [])
        .toSorted()

/** The type of an object that has every message of a table as a function of its facts, as TypeScript. */
export const typesOf = (table: Table): string => {
  const lines = Object.entries(table).map(([key, message]) => {
    const facts = factsOf(message).map((name) => `readonly ${name}: string | number`)
    return `  readonly ${JSON.stringify(key)}: (${facts.length > 0 ? `facts: { ${facts.join('; ')} }` : ''}) => string\n`
  })
  return `export interface Messages {\n${lines.join('')}}\n`
}
