import type { Column, ThingSet } from '@botgarten/content/things'
import { formatNumber } from '#drawing/numbers.ts'
import { language } from '#words/language.svelte.ts'
import { m } from '#words/message.ts'
import { setOf } from '#figures/things/sets.ts'
import type { Work } from '../model/work.ts'

type Message = () => string

const features: { readonly [feature: string]: Message } = {
  width: m['sorting.feature.width'],
  height: m['sorting.feature.height'],
  length: m['sorting.feature.length'],
  fill: m['sorting.feature.fill'],
  colour: m['sorting.feature.colour'],
  material: m['sorting.feature.material'],
  teeth: m['sorting.feature.teeth'],
  diameter: m['sorting.feature.diameter'],
  holes: m['sorting.feature.holes'],
  rim: m['sorting.feature.rim'],
  right: m['sorting.feature.right'],
  up: m['sorting.feature.up'],
}
const parts: { readonly [part: string]: Message } = {
  red: m['sorting.part.red'],
  green: m['sorting.part.green'],
  blue: m['sorting.part.blue'],
  glass: m['sorting.option.glass'],
  plastic: m['sorting.option.plastic'],
  clay: m['sorting.option.clay'],
  rim: m['sorting.option.rim'],
  plain: m['sorting.option.plain'],
}
const kinds: { readonly [kind: string]: Message } = {
  bottle: m['sorting.kind.bottle'],
  cup: m['sorting.kind.cup'],
  glass: m['sorting.kind.glass'],
  round: m['sorting.kind.round'],
  long: m['sorting.kind.long'],
  tooth: m['sorting.kind.tooth'],
  button: m['sorting.kind.button'],
}
const setNames: { readonly [set: string]: Message } = {
  vessels: m['sorting.set.vessels'],
  leaves: m['sorting.set.leaves'],
  buttons: m['sorting.set.buttons'],
}

export const setName = (id: string): string => setNames[id]?.() ?? id
/** A file's column keeps the name that stands in the file. */
export const featureName = (feature: string): string => features[feature]?.() ?? feature
export const columnName = ({ feature, part }: Column): string => parts[part]?.() ?? featureName(feature)

export const number = (value: number, digits = 1): string => formatNumber(value, language.locale, digits)

/** What a place on the plane means in the column's own unit. */
export function meaning(onPlane: number, { low, high, scale, unit }: Column): string {
  const raw = low + (onPlane / scale) * (high - low)
  return [number(raw, high - low < 5 ? 2 : 0), unit].filter(Boolean).join(' ')
}

/** A thing with its place in the row, for those who do not see it. */
export const thingName = (set: ThingSet, index: number): string =>
  `${kinds[set.things[index]!.kind]!()} ${index + 1}`

/** A thing or a point of the plane. */
export const nameOf = ({ source, set }: Work, point: number): string =>
  source === 'things' ? thingName(setOf(set), point) : m['sorting.point']({ number: point + 1 })

/** A column with the feature it belongs to. */
export function titleOf(column: Column): string {
  const [part, name] = [columnName(column), featureName(column.feature)]
  return part === name ? name : `${name}: ${part}`
}
