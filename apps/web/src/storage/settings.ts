import { languages } from 'content:words'
import * as v from 'valibot'
import { ownName } from './account.ts'

const option = v.optional(v.boolean())
const level = v.picklist(['starter', 'explorer', 'expert'])
const share = v.pipe(v.number(), v.minValue(0), v.maxValue(1))
const two = v.optional(v.tuple([share, share]))
/** What was sorted last is a child's work: its playground reads it as carefully as anything foreign. */
const mostSorted = 1_000_000

/** All that is set on a device, and what each may be. A setting without a line here would not go home. */
export const settings = {
  comfort: v.strictObject({ projector: option, quiet: option, letters: option, aloud: option }),
  /** For which robot a program is shown as Python. */
  dialect: v.picklist(['pybricks', 'ev3dev2', 'spike']),
  /** Does code that is shown raise errors where its program has gaps? */
  'code-gaps': v.boolean(),
  /** Does the robot of such code go on learning by trying? */
  'code-learner': v.boolean(),
  language: v.picklist(languages),
  /** What somebody put together to be printed: items and cards by name, for whom, or how often. */
  'my-set': v.strictObject({
    name: v.pipe(v.string(), v.maxLength(60)),
    children: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(99)),
    lines: v.pipe(
      v.array(
        v.strictObject({
          of: v.pipe(v.string(), v.regex(/^(item|card):[a-z0-9-]{1,60}$/)),
          for: v.union([v.picklist(['teacher', 'child', 'pair']), v.pipe(v.number(), v.minValue(2))]),
          times: v.optional(v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(999))),
        }),
      ),
      v.maxLength(200),
    ),
    paper: v.picklist(['a4', 'a5']),
    grey: v.boolean(),
    sets: v.optional(v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(20))),
    languages: v.optional(v.pipe(v.array(v.picklist(languages)), v.maxLength(languages.length))),
  }),
  'network-level': level,
  'network-tens': v.boolean(),
  'q-level': level,
  /** The drawer of robots looks at each alone: one that is damaged takes no other with it. */
  robots: v.record(v.pipe(v.string(), v.maxLength(100)), v.unknown()),
  settings: v.strictObject({ rays: v.boolean(), all: v.optional(v.boolean()), trail: v.boolean() }),
  sizes: v.strictObject({ columns: two, stacked: two, rows: two }),
  sorting: v.pipe(
    v.record(v.string(), v.unknown()),
    v.check((sorting) => JSON.stringify(sorting).length <= mostSorted),
  ),
  sound: v.boolean(),
  tour: v.literal('seen'),
  /** Cages of the reward zoo: what was guessed, and whether it was mended. */
  zoo: v.record(
    v.pipe(v.string(), v.maxLength(60)),
    v.strictObject({ guess: v.picklist(['wish', 'other', 'never']), mended: v.boolean() }),
  ),
  /** Cages in which Bo tries with its own sensors. */
  'zoo-senses': v.record(
    v.pipe(v.string(), v.maxLength(60)),
    v.strictObject({
      guess: v.picklist(['cheats', 'honest', 'other']),
      watched: v.boolean(),
      mended: v.boolean(),
    }),
  ),
} satisfies { readonly [name: string]: v.GenericSchema }

/** How the device is set up for whoever uses it; all else is a pupil's own where there is one. */
const ofTheDevice = ['comfort', 'language', 'settings', 'sizes', 'sound', 'tour']

/** Where a setting lies in the browser's storage. */
export const placeOfSetting = (name: string): string =>
  ofTheDevice.includes(name) ? `botgarten.${name}` : ownName(`botgarten.${name}`)

/** A setting of this device, or the preset where the browser keeps nothing, or something that is no such setting. */
export function readSetting<Value>(name: string, preset: Value): Value {
  try {
    const text = localStorage.getItem(placeOfSetting(name))
    const value: unknown = text === null ? preset : JSON.parse(text)
    return isSetting(name, value) ? (value as Value) : preset
  } catch {
    return preset
  }
}

/** What is named in no table is looked at by the one who reads it. */
const isSetting = (name: string, value: unknown): boolean =>
  !Object.hasOwn(settings, name) || v.is(settings[name as keyof typeof settings], value)

export function writeSetting(name: string, value: unknown): void {
  try {
    localStorage.setItem(placeOfSetting(name), JSON.stringify(value))
  } catch {
    // A device that keeps nothing shows its presets the next time; there is nothing to lose.
  }
}
