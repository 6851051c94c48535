import type { Missing } from '@botgarten/lab'
import { formatNumber } from '#drawing/numbers.ts'
import { distance } from '#figures/world/distance.ts'
import { language } from '#words/language.svelte.ts'
import { message } from '#words/message.ts'

type Fact = Missing['facts'][string]

/** Colours of the floor as sensors tell them apart. */
const colours: { readonly [hex: string]: string } = {
  '#000000': 'black',
  '#0057A6': 'blue',
  '#00642E': 'green',
  '#F7D117': 'yellow',
  '#B30006': 'red',
  '#FFFFFF': 'white',
  '#532115': 'brown',
}

const colourOf = (hex: Fact) => message(`missed.colour.${colours[String(hex)] ?? 'none'}`)
const lampOf = (name: Fact) => message(`missed.lamp.${name}`)
const cm = (length: Fact) => distance(Number(length))

/** How a fact is read, by its name; other numbers with one digit behind the comma. */
const read: { readonly [name: string]: (fact: Fact) => string } = {
  colour: colourOf,
  other: colourOf,
  shone: lampOf,
  lamp: lampOf,
  away: cm,
}
/** Kinds whose limits are lengths. */
const lengths: readonly string[] = ['cruises', 'sings', 'turnsAway']

/** What a run has missed, in one sentence. @param place what the card's goal stands at: a `flag`, else '' */
export function sentenceOf({ kind, what, facts }: Missing, place: string): string {
  const readable = Object.entries(facts).map(([name, fact]): [string, Fact] => {
    if (read[name]) return [name, read[name](fact)]
    if (typeof fact === 'string') return [name, fact]
    const isLength = lengths.includes(kind) && (name === 'least' || name === 'most')
    return [name, isLength ? cm(fact) : formatNumber(fact, language.locale, fact < 10 ? 1 : 0)]
  })
  return message(`missed.${kind}.${what}`, { ...Object.fromEntries(readable), place })
}
