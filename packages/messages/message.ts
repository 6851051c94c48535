// Messages in the inlang message format: https://inlang.com/m/reootnfj/plugin-inlang-messageFormat
// Paraglide makes the types of the same files; a test holds `fill` to the functions that Paraglide compiles.

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
  const pattern = typeof message === 'string' ? message : chosen(message[0], facts, locale)
  return pattern.replace(/\\([{}\\])|\{(\w+)\}/g, (gap, escaped: string | undefined, name: string) =>
    escaped === undefined ? String(facts[name] ?? gap) : escaped,
  )
}

function chosen({ declarations, match, locale: own }: Variants, facts: Facts, locale: string): string {
  const selected = new Map(Object.entries(facts).map(([name, fact]) => [name, String(fact)]))
  for (const declaration of declarations) {
    const [, local, input] = /^local (\w+) = (\w+): plural$/.exec(declaration) ?? []
    if (local && input) selected.set(local, rulesOf(own ?? locale).select(Number(facts[input])))
  }
  const fits = (selector: string) => {
    const [name = '', wanted] = selector.trim().split('=')
    return wanted === '*' || selected.get(name) === wanted
  }
  const found = Object.entries(match).find(([selectors]) => selectors.split(',').every(fits))
  return found?.[1] ?? ''
}

const rules = new Map<string, Intl.PluralRules>()

function rulesOf(locale: string): Intl.PluralRules {
  const known = rules.get(locale) ?? new Intl.PluralRules(locale)
  rules.set(locale, known)
  return known
}
