import type { CageRows, SenseCage } from '@botgarten/experiments/cages'
import { limits, payKinds, problemOf, type Sentence, type Trial } from '@botgarten/learning/q-senses'
import * as v from 'valibot'

const id = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]*$/))
const cm = v.pipe(v.number(), v.minValue(0), v.maxValue(10_000))
const pose = v.strictObject({ x: cm, y: cm, heading: v.pipe(v.number(), v.minValue(0), v.maxValue(360)) })
const share = v.pipe(v.number(), v.minValue(0), v.maxValue(1))
const percent = v.pipe(v.number(), v.minValue(-100), v.maxValue(100))
const whole = v.pipe(v.number(), v.integer(), v.minValue(0))

const sentence: v.GenericSchema<unknown, Sentence> = v.strictObject({
  for: v.picklist(payKinds),
  coins: v.pipe(v.number(), v.minValue(-limits.coins), v.maxValue(limits.coins)),
})
const pay = v.pipe(v.array(sentence), v.minLength(1), v.maxLength(limits.sentences))

const trial: v.GenericSchema<unknown, Omit<Trial, 'seed'>> = v.pipe(
  v.strictObject({
    sensors: v.array(
      v.strictObject({
        port: v.picklist(['1', '2', '3', '4']),
        mode: v.picklist(['distance', 'light', 'colour', 'touch']),
      }),
    ),
    edges: v.array(v.array(v.pipe(v.number(), v.minValue(0), v.maxValue(100)))),
    bump: v.boolean(),
    actions: v.pipe(v.array(v.strictObject({ left: percent, right: percent })), v.maxLength(limits.actions)),
    hold: v.pipe(v.number(), v.integer(), v.minValue(limits.hold[0]), v.maxValue(limits.hold[1])),
    ...{ pay, bumpEnds: v.boolean(), alpha: share, gamma: share, rho: share },
  }),
  v.check(({ sensors, edges }) => sensors.length === edges.length, 'Each sensor has its edges.'),
  v.check((one) => problemOf({ ...one, seed: 0 }) === null, 'Nothing can be learned here.'),
)

const between = v.exactOptional(v.tuple([v.number(), v.number()]))

const cage: v.GenericSchema<unknown, SenseCage> = v.pipe(
  v.strictObject({
    ...{ id, world: id, trial, mend: pay },
    starts: v.pipe(v.array(pose), v.minLength(1), v.maxLength(8)),
    cheats: v.strictObject({
      ...{ cm: between, tiles: between, touching: between, bumps: between },
      ...{ free: between, near: between, line: between, ended: between },
    }),
  }),
  v.check(({ cheats }) => Object.keys(cheats).length > 0, 'A cage says how its cheat is known.'),
)

/** Reads `cage.json`. @throws ValiError that names the place where the file is wrong. */
export const readSenseCage = (json: unknown): SenseCage => v.parse(cage, json)

const measured = {
  ...{ cm: v.number(), tiles: v.number(), touching: v.number(), bumps: v.number() },
  ...{ free: v.number(), near: v.number(), line: v.number(), ended: v.number(), pay: v.number() },
}

const rows: v.GenericSchema<unknown, CageRows> = v.strictObject({
  minutes: whole,
  honest: v.nullable(v.strictObject(measured)),
  bos: v.pipe(
    v.array(
      v.strictObject({ seed: whole, cheats: v.boolean(), ...measured, mended: v.nullable(v.number()) }),
    ),
    v.minLength(1),
  ),
  shown: v.strictObject({ seed: whole, q: v.array(v.number()), tries: v.array(whole), moves: whole }),
})

/** Reads `rows.json`, what was measured of a cage. @throws ValiError */
export const readCageRows = (json: unknown): CageRows => v.parse(rows, json)
