import type { Outcome } from '@botgarten/maps/zoo'
import { readItemText } from './itemText.ts'
import type { ItemNode } from './itemTypes.ts'
import { plainOf } from './markdown.ts'

/** By outcome a sentence. */
type ByOutcome = { readonly [outcome in Outcome]: string }

/** A cage in one language. */
export interface CageText {
  readonly title: string
  /** The mission. */
  readonly wish: string
  /** What each rule of the pay is for. */
  readonly pay: readonly string[]
  /** Why it sounds right. */
  readonly soundsRight: string
  /** What Bo may do: to be guessed. */
  readonly guess: ByOutcome
  readonly does: ByOutcome
  /** Why Bo does it. */
  readonly why: string
  /** What is asked beside what can be changed, and the words of each option. */
  readonly mend: string
  readonly options: { readonly [id: string]: string }
  /** Where it happened in the world. */
  readonly happened: string
  readonly hints: readonly string[]
}

/**
 * Reads a cage's words: `# Title`, then the sections Wish, Pay, Sounds right, Guess, Bo does, Why, Mend, Happened and Hints (named
 * so in every language). @throws SyntaxError that names what is missing.
 */
export function readCageText(markdown: string): CageText {
  const { title, sections } = readItemText(markdown)
  const body = (name: string) => {
    const found = sections.find((section) => section.title === name)
    if (!found?.body.length) throw new SyntaxError(`The section "${name}" is missing.`)
    return found.body
  }
  const sentence = (name: string) => plainOf(body(name)[0]!)
  const lines = (name: string) => linesOf(body(name), name)
  return {
    ...{ title, wish: sentence('Wish'), pay: lines('Pay'), soundsRight: sentence('Sounds right') },
    ...{ guess: byOutcome(lines('Guess')), does: byOutcome(lines('Bo does')), why: sentence('Why') },
    mend: sentence('Mend'),
    options: body('Mend').length > 1 ? byId(linesOf(body('Mend').slice(1), 'Mend')) : {},
    ...{ happened: sentence('Happened'), hints: lines('Hints') },
  }
}

export function linesOf([list]: readonly ItemNode[], name: string): readonly string[] {
  if (list?.type !== 'list') throw new SyntaxError(`The section "${name}" must be a list.`)
  return list.children.map((item) => plainOf(item))
}

export function byId(lines: readonly string[]): { readonly [id: string]: string } {
  return Object.fromEntries(
    lines.map((line) => {
      const [, id, words] = /^([a-z0-9-]+): (.+)$/.exec(line) ?? []
      if (!id || !words) throw new SyntaxError(`"${line}" must be "name: words".`)
      return [id, words]
    }),
  )
}

function byOutcome(lines: readonly string[]): ByOutcome {
  const { wish, other, never } = byId(lines)
  if (!wish || !other || !never) throw new SyntaxError('There are words for "wish", "other" and "never".')
  return { wish, other, never }
}
