// Sentences that Paraglide compiled from our messages, as committed data: `npm run paraglide` writes them.
import { createHash } from 'node:crypto'
import { join } from 'node:path'
import { factsOf } from '../facts.ts'
import { filesIn, ownTableOf } from '../folder.ts'
import type { Facts, Message } from '../message.ts'
import type { Table } from '../table.ts'

export const referenceFile = join(import.meta.dirname, '../reference/paraglide.json')

/** The content of the reference file. */
export interface Reference {
  /** Packages that compiled the sentences, with their versions. */
  readonly madeBy: { readonly [name: string]: string }
  /** By language and key: the fingerprint of the message and one sentence for each of `casesOf`. */
  readonly sentences: {
    readonly [locale: string]: { readonly [key: string]: readonly [fingerprint: string, ...string[]] }
  }
}

const numbers = [0, 1, 2, 3, 5, 10, 11, 21, 22, 100, 101, 999, 1000, 1001, 12345]

/** Facts to try a message with: its first number takes every value, the others are 1 or equal to the first. */
export function casesOf(message: Message): readonly Facts[] {
  const names = factsOf(message)
  const withOthers = (first: number) => (names.length > 1 && first !== 1 ? [1, first] : [1])
  return numbers.flatMap((first) =>
    withOthers(first).map((other) =>
      Object.fromEntries(names.map((name, at) => [name, at === 0 ? first : other])),
    ),
  )
}

/** Eight hexadecimal digits that change with a message. */
export const fingerprintOf = (message: Message): string =>
  createHash('sha256').update(JSON.stringify(message)).digest('hex').slice(0, 8)

/** Messages of a language that change with a number, by key; those for Blockly have a format of their own. */
export const changingIn = (locale: string): Table =>
  Object.fromEntries(
    filesIn()
      .filter((file) => file !== 'blockly')
      .flatMap((file) => Object.entries(ownTableOf(file, locale)))
      .filter(([, message]) => typeof message !== 'string'),
  )
