import type { Column, Feature, Thing, ThingSet } from '../schema/thingTypes.ts'

/** How wide the plane is: all features count the same, whatever their unit. */
const PLANE = 10

/** The numbers that are compared when these features count, in the order of the set. */
export function columnsOf({ features, things }: ThingSet, counting: readonly string[]): Column[] {
  return features.filter(({ id }) => counting.includes(id)).flatMap((feature) => columnsFor(feature, things))
}

function columnsFor(feature: Feature, things: readonly Thing[]): Column[] {
  const column = { feature: feature.id, part: '', unit: '', scale: PLANE }
  if (feature.kind === 'number') {
    const values = things.map(({ values }) => Number(values[feature.id]))
    return [{ ...column, unit: feature.unit, low: Math.min(...values), high: Math.max(...values) }]
  }
  if (feature.kind === 'colour')
    return ['red', 'green', 'blue'].map((part) => ({ ...column, part, low: 0, high: 255 }))
  // Two options lie on two axes: with this scale they are a plane's width apart.
  return feature.options.map((part) => ({ ...column, part, low: 0, high: 1, scale: PLANE * Math.SQRT1_2 }))
}

/** What a thing has in a column, in its own unit. */
export function rawOf({ features }: ThingSet, { values }: Thing, { feature, part }: Column): number {
  const kind = features.find(({ id }) => id === feature)?.kind
  const value = values[feature]
  if (kind === 'number') return Number(value)
  if (kind === 'choice') return value === part ? 1 : 0
  const at = 1 + 2 * ['red', 'green', 'blue'].indexOf(part)
  return parseInt(String(value).slice(at, at + 2), 16)
}

/** From its own unit to the plane. */
export const onPlane = (raw: number, { low, high, scale }: Column): number =>
  high === low ? scale / 2 : ((raw - low) / (high - low)) * scale
