import * as v from 'valibot'
import type { Plan } from './planTypes.ts'

const minutes = v.pipe(v.number(), v.integer(), v.minValue(1))
const lesson = v.pipe(v.string(), v.regex(/^(E |L )?\d+$/))

export const copies = v.array(
  v.strictObject({
    of: v.pipe(v.string(), v.regex(/^(item|card):[a-z0-9-]+$/)),
    for: v.union([v.picklist(['teacher', 'child', 'pair']), v.pipe(v.number(), v.integer(), v.minValue(2))]),
  }),
)

/** What is said of runs. */
export const claims = v.array(
  v.strictObject({
    card: v.string(),
    weights: v.record(v.string(), v.record(v.string(), v.number())),
    place: minutes,
    passed: v.nullable(minutes),
  }),
)

export const plan: v.GenericSchema<unknown, Plan> = v.strictObject({
  lesson,
  double: v.nullable(
    v.strictObject({ name: v.pipe(v.string(), v.regex(/^[A-C]$/)), lessons: v.tuple([lesson, lesson]) }),
  ),
  copies,
  steps: v.pipe(v.array(v.strictObject({ minutes })), v.minLength(1)),
  claims,
})
