import { limits, payKinds, statesOf, type TableBrain } from '@botgarten/learning/q-senses'
import * as v from 'valibot'
import { finite } from './schema-program.ts'

const percent = v.pipe(finite, v.minValue(-100), v.maxValue(100))
const share = v.pipe(finite, v.minValue(0), v.maxValue(1))
const whole = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(1_000_000_000))
/** No value that 20 coins in each of a thousand units could come to is as large. */
const value = v.pipe(finite, v.minValue(-1e9), v.maxValue(1e9))
const lamps = ['green', 'orange', 'red', 'off'] as const
const place = v.pipe(finite, v.minValue(0), v.maxValue(10_000))
const most = limits.states * limits.actions

const rising = (edges: number[]) => edges.every((edge, k) => k === 0 || edge > edges[k - 1]!)
const edges = v.pipe(
  v.array(v.pipe(finite, v.minValue(-1000), v.maxValue(1000))),
  v.maxLength(limits.states),
  v.check(rising, 'Edges rise.'),
)

/** A table of as many values as it has states and actions. */
export const tableSchema: v.GenericSchema<unknown, TableBrain> = v.pipe(
  v.object({
    kind: v.literal('table'),
    sensors: v.pipe(
      v.array(
        v.object({
          port: v.picklist(['1', '2', '3', '4']),
          mode: v.picklist(['distance', 'light', 'colour', 'touch']),
        }),
      ),
      v.maxLength(limits.sensors),
    ),
    edges: v.pipe(v.array(edges), v.maxLength(limits.sensors)),
    ...{ bump: v.boolean(), bumpEnds: v.boolean() },
    actions: v.pipe(
      v.array(v.object({ left: percent, right: percent, lamp: v.exactOptional(v.picklist(lamps)) })),
      v.minLength(2),
      v.maxLength(limits.actions),
    ),
    hold: v.pipe(whole, v.minValue(limits.hold[0]), v.maxValue(limits.hold[1])),
    pay: v.pipe(
      v.array(
        v.object({
          for: v.picklist(payKinds),
          coins: v.pipe(finite, v.minValue(-limits.coins), v.maxValue(limits.coins)),
        }),
      ),
      v.maxLength(limits.sentences),
    ),
    ...{ alpha: share, gamma: share, rho: share, seed: whole, moves: whole },
    starts: v.exactOptional(v.pipe(v.array(v.object({ x: place, y: place })), v.maxLength(limits.starts))),
    q: v.pipe(v.array(value), v.maxLength(most)),
    tries: v.pipe(v.array(whole), v.maxLength(most)),
    curve: v.exactOptional(
      v.pipe(v.array(v.object({ pay: value, bumps: whole })), v.maxLength(limits.minutes)),
    ),
  }),
  v.check(
    ({ sensors, edges, bump, actions, q, tries }) =>
      sensors.length === edges.length &&
      statesOf({ edges, bump }) <= limits.states &&
      q.length === statesOf({ edges, bump }) * actions.length &&
      tries.length === q.length,
    'A table has a value for each action of each state.',
  ),
)
