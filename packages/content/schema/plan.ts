import * as v from 'valibot'
import type { Claim, Plan } from './planTypes.ts'
import { questionRun } from './question.ts'

const count = v.pipe(v.number(), v.integer(), v.minValue(1))
/** A count that may be 0. */
const none = v.pipe(v.number(), v.integer(), v.minValue(0))
const percents = v.strictObject({ practised: v.exactOptional(none), test: v.exactOptional(none) })
// Pages read plans: no name here brings the lab along.
const named = ['cm', 'tiles', 'touching', 'bumps', 'free', 'near', 'line', 'ended', 'pay'] as const
const paid = ['wheels', 'ahead', 'way'] as const
const lesson = v.pipe(v.string(), v.regex(/^(E |L )?\d+$/))

export const copies = v.array(
  v.strictObject({
    of: v.pipe(v.string(), v.regex(/^(item|card):[a-z0-9-]+$/)),
    for: v.union([v.picklist(['teacher', 'child', 'pair']), v.pipe(v.number(), v.integer(), v.minValue(2))]),
  }),
)

const claim: v.GenericSchema<unknown, Claim> = v.union([
  v.strictObject({
    card: v.string(),
    weights: v.exactOptional(v.record(v.string(), v.record(v.string(), v.number()))),
    file: v.exactOptional(v.string()),
    numbers: v.exactOptional(v.record(v.string(), v.number())),
    place: count,
    passed: v.nullable(count),
  }),
  v.strictObject({
    ...{ learns: v.string(), tries: count, of: count },
    found: none,
    settings: v.exactOptional(v.record(v.string(), v.number())),
  }),
  v.strictObject({
    practises: v.string(),
    file: v.exactOptional(v.string()),
    settings: v.exactOptional(v.record(v.string(), v.union([v.number(), v.string(), v.boolean()]))),
    hidden: v.exactOptional(v.array(v.strictObject({ neurons: count, activation: v.string() }))),
    wishes: v.exactOptional(v.record(v.string(), v.array(v.number()))),
    aside: v.exactOptional(v.array(count)),
    off: v.exactOptional(v.record(v.string(), percents)),
    weights: v.exactOptional(v.record(v.string(), v.record(v.string(), v.number()))),
    lowest: v.exactOptional(v.array(count)),
    misses: v.exactOptional(v.array(v.string())),
    of: v.exactOptional(count),
    found: v.exactOptional(none),
  }),
  v.strictObject({ run: questionRun, answer: v.string() }),
  v.strictObject({
    race: v.strictObject({
      ...{ map: v.string(), racers: v.array(v.string()), criterion: v.string() },
      ...{ tries: count, runs: count, seed: count },
    }),
    wins: v.array(v.string()),
    bills: v.record(v.string(), v.record(v.string(), v.nullable(v.number()))),
  }),
  v.strictObject({
    course: v.string(),
    lanes: v.record(v.string(), v.strictObject({ cm: v.number(), bumps: v.number() })),
  }),
  v.strictObject({
    ...{ cage: v.string(), cheating: none, failing: none },
    those: v.record(v.picklist(named), v.tuple([v.number(), v.number()])),
    honest: v.exactOptional(v.record(v.picklist(named), v.number())),
  }),
  v.strictObject({ trying: v.string(), passes: v.nullable(count), bumps: v.array(none) }),
  v.strictObject({
    ahead: v.string(),
    from: v.strictObject({ x: v.number(), y: v.number(), heading: v.number() }),
    coins: v.record(v.picklist(paid), v.number()),
  }),
])

/** What is said of runs. */
export const claims = v.array(claim)

export const plan: v.GenericSchema<unknown, Plan> = v.strictObject({
  lesson,
  double: v.nullable(
    v.strictObject({ name: v.pipe(v.string(), v.regex(/^[A-C]$/)), lessons: v.tuple([lesson, lesson]) }),
  ),
  copies,
  steps: v.pipe(v.array(v.strictObject({ minutes: count })), v.minLength(1)),
  claims,
})
