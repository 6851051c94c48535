// Messages in the inlang message format: https://inlang.com/m/reootnfj/plugin-inlang-messageFormat
// paraglide.test.ts compares `fill` with the sentences of Paraglide, which reads the same format.
import { writeNumber } from './numbers.ts'

/** Values for a message's placeholders. */
export type Facts = { readonly [name: string]: string | number }

/** A sentence that changes with a number. */
export interface Variants {
  /** `input count`, `local countPlural = count: plural`. */
  readonly declarations: readonly string[]
  readonly selectors: readonly string[]
  /** By what the selectors are (`countPlural=one`, several with commas, `*` for anything); the first that fits counts. */
  readonly match: { readonly [selected: string]: string }
  /** The language of the sentence, where it is not the one that was asked for. */
  readonly locale?: string
}

export type Message = string | readonly [Variants]

/** Every form of a message, with its gaps. */
export const formsOf = (message: Message): readonly string[] =>
  typeof message === 'string' ? [message] : Object.values(message[0].match)

/** A message with its facts; a placeholder without a fact stays as it is. */
export function fill(message: Message, facts: Facts, locale: string): string {
  if (typeof message === 'string') return withFacts(message, facts)
  const { declarations, match, locale: own } = message[0]
  const all = { ...facts, ...localsOf(declarations, facts, own ?? locale) }
  return withFacts(formFor(match, all), all)
}

const withFacts = (pattern: string, facts: Facts) =>
  pattern.replace(/\\([{}\\])|\{(\w+)\}/g, (gap, escaped: string | undefined, name: string) =>
    escaped === undefined ? String(facts[name] ?? gap) : escaped,
  )

/** The first form that fits. */
function formFor(match: Variants['match'], facts: Facts): string {
  const fits = (selector: string) => {
    const [name = '', wanted] = selector.trim().split('=')
    return wanted === '*' || String(facts[name]) === wanted
  }
  return Object.entries(match).find(([selectors]) => selectors.split(',').every(fits))?.[1] ?? ''
}

/** `local countPlural = count: plural` and `local countNumber = count: number`. */
const localsOf = (declarations: readonly string[], facts: Facts, locale: string): Facts =>
  Object.fromEntries(
    declarations.flatMap((declaration) => {
      const [, local = '', input = '', kind] = /^local (\w+) = (\w+): (\w+)$/.exec(declaration) ?? []
      return kind ? [[local, functions(locale)[kind]!(Number(facts[input]))]] : []
    }),
  )

type Functions = { readonly [kind: string]: (value: number) => string }
const known = new Map<string, Functions>()

/** What a declaration may make of a number, by the rules of a language. */
function functions(locale: string): Functions {
  const made = known.get(locale)
  if (made) return made
  const rules = new Intl.PluralRules(locale)
  const own: Functions = {
    plural: (value) => rules.select(value),
    number: (value) => writeNumber(value, locale),
  }
  known.set(locale, own)
  return own
}
