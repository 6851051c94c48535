import { byId, linesOf } from './cageText.ts'
import { readItemText } from './itemText.ts'
import { plainOf } from './markdown.ts'

/** What a child may guess, in the order that is shown. */
export const guesses = ['cheats', 'honest', 'other'] as const
export type SenseGuess = (typeof guesses)[number]

/** A cage of the zoo of sensors in one language. */
export interface SenseCageText {
  /** The animal's name. */
  readonly title: string
  /** Why its pay sounds right. */
  readonly soundsRight: string
  /** What Bo may do: to be guessed. */
  readonly guess: { readonly [guess in SenseGuess]: string }
  /** What it does there, and what it does otherwise. */
  readonly does: { readonly [does in 'cheats' | 'other']: string }
  /** Why Bo does it; of a riddle: why so few do. */
  readonly why: string
  /** What helps. */
  readonly mend: string
  readonly hints: readonly string[]
}

/**
 * Reads its words: `# Animal`, then the sections Sounds right, Guess, Bo does, Why, Mend and Hints (named so in every
 * language). @throws SyntaxError that names what is missing.
 */
export function readSenseCageText(markdown: string): SenseCageText {
  const { title, sections } = readItemText(markdown)
  const body = (name: string) => {
    const found = sections.find((section) => section.title === name)
    if (!found?.body.length) throw new SyntaxError(`The section "${name}" is missing.`)
    return found.body
  }
  const sentence = (name: string) => plainOf(body(name)[0]!)
  const named = <Name extends string>(name: string, all: readonly Name[]) => {
    const words = byId(linesOf(body(name), name))
    const missing = all.find((one) => !words[one])
    if (missing) throw new SyntaxError(`The section "${name}" has no words for "${missing}".`)
    return words as { readonly [one in Name]: string }
  }
  return {
    ...{ title, soundsRight: sentence('Sounds right'), guess: named('Guess', guesses) },
    does: named('Bo does', ['cheats', 'other']),
    ...{ why: sentence('Why'), mend: sentence('Mend'), hints: linesOf(body('Hints'), 'Hints') },
  }
}
