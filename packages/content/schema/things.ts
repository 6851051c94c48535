import * as v from 'valibot'
import type { Feature, ThingSet } from './thingTypes.ts'

const name = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]*$/))

const feature: v.GenericSchema<unknown, Feature> = v.variant('kind', [
  v.strictObject({ id: name, kind: v.literal('number'), unit: v.string() }),
  v.strictObject({ id: name, kind: v.literal('colour') }),
  v.strictObject({ id: name, kind: v.literal('choice'), options: v.pipe(v.array(name), v.minLength(2)) }),
])

function fits(kind: Feature, value: unknown): boolean {
  if (kind.kind === 'number') return typeof value === 'number' && Number.isFinite(value)
  if (kind.kind === 'choice') return kind.options.includes(String(value))
  return /^#[0-9A-F]{6}$/.test(String(value))
}

const set = v.pipe(
  v.strictObject({
    id: name,
    features: v.pipe(v.array(feature), v.minLength(1)),
    things: v.pipe(
      v.array(
        v.strictObject({
          id: name,
          kind: name,
          values: v.record(v.string(), v.union([v.number(), v.string()])),
        }),
      ),
      v.minLength(2),
    ),
  }),
  v.check(
    ({ features, things }) =>
      things.every(
        ({ values }) =>
          Object.keys(values).length === features.length &&
          features.every((one) => fits(one, values[one.id])),
      ),
    'A thing lacks a feature of its set, or has one that is not of its kind.',
  ),
)

/** Reads `things.json`. @throws ValiError that names the place where the file is wrong. */
export const readThings = (json: unknown): ThingSet => v.parse(set, json)
