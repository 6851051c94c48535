import { untouched, settingsOf, type Cage, type Pay } from '@botgarten/maps/zoo'
import * as v from 'valibot'
import { https } from './checked.ts'

const id = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]*$/))
const station = v.pipe(v.number(), v.integer(), v.minValue(0))
const share = v.pipe(v.number(), v.minValue(0), v.maxValue(1))
const reward = v.pipe(v.number(), v.minValue(-100), v.maxValue(100))

const pay: v.GenericSchema<unknown, Pay> = v.variant('for', [
  v.strictObject({ for: v.literal('goal'), reward }),
  v.strictObject({ for: v.literal('station'), station, reward }),
  v.strictObject({ for: v.literal('move'), reward }),
  v.strictObject({
    ...{ for: v.literal('road'), from: station, to: station, reward },
    both: v.exactOptional(v.literal(true)),
  }),
  v.strictObject({ for: v.literal('away'), from: station, reward }),
  v.strictObject({ for: v.literal('nearer'), reward, back: v.picklist(['nothing', 'same', 'exact']) }),
])
const pays = v.pipe(v.array(pay), v.minLength(1))
const endless = v.exactOptional(v.literal(true))

const mend: v.GenericSchema<unknown, Cage['mend']> = v.union([
  v.strictObject({
    ...{ rule: station, least: v.number(), most: v.number(), step: v.pipe(v.number(), v.minValue(1)) },
    costs: v.exactOptional(v.literal(true)),
  }),
  v.strictObject({
    options: v.pipe(v.array(v.strictObject({ id, pay: pays, endless })), v.minLength(2), v.maxLength(4)),
  }),
])

const outcome = v.picklist(['wish', 'other', 'never'])

const cage: v.GenericSchema<unknown, Cage> = v.pipe(
  v.strictObject({
    ...{ id, start: station, goal: station, pay: pays, endless, mend, solution: v.number() },
    wish: v.strictObject({
      passes: v.exactOptional(v.array(station)),
      moves: v.exactOptional(v.pipe(v.number(), v.integer(), v.minValue(1))),
    }),
    claim: v.strictObject({ aLot: outcome, aLittle: outcome }),
    circle: v.exactOptional(v.array(station)),
    why: v.exactOptional(v.strictObject({ at: station, to: station })),
    setting: v.strictObject({
      ...{ alpha: share, gamma: share, nu: share, rho: share },
      episodes: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(10_000)),
    }),
    source: v.strictObject({
      ...{ by: v.string(), title: v.string(), in: v.string() },
      year: v.pipe(v.number(), v.integer(), v.minValue(1900)),
      address: v.exactOptional(https),
    }),
  }),
  v.check(({ mend: one, pay: rules }) => 'options' in one || one.rule < rules.length, 'No such rule.'),
  v.check((one) => settingsOf(one.mend).includes(one.solution), 'The mend has no such setting.'),
  v.check((one) => settingsOf(one.mend).includes(untouched(one)), 'The mend does not begin at what is paid.'),
)

/** Reads `cage.json`. @throws ValiError that names the place where the file is wrong. */
export const readCage = (json: unknown): Cage => v.parse(cage, json)
