import { locales } from '../../../project.inlang/settings.json'
import { comfort } from '#lib/state/comfort.svelte.ts'
import { language, type Locale } from '#lib/words/language.svelte.ts'
import * as v from 'valibot'

const wish = v.optional(v.boolean())
const level = v.picklist(['starter', 'explorer', 'expert'])
const share = v.pipe(v.number(), v.minValue(0), v.maxValue(1))
const two = v.optional(v.tuple([share, share]))
/** What was sorted last is a child's work: its playground reads it as carefully as anything foreign. */
const mostSorted = 1_000_000

/** All that is set on a device, and what each may be. A setting without a line here would stay behind. */
const travels = {
  comfort: v.strictObject({ projector: wish, quiet: wish, letters: wish, aloud: wish }),
  language: v.picklist(locales as Locale[]),
  'network-level': level,
  'network-tens': v.boolean(),
  'q-level': level,
  settings: v.strictObject({ rays: v.boolean(), trail: v.boolean() }),
  sizes: v.strictObject({ columns: two, stacked: two, rows: two }),
  sorting: v.pipe(
    v.record(v.string(), v.unknown()),
    v.check((sorting) => JSON.stringify(sorting).length <= mostSorted),
  ),
  sound: v.boolean(),
  tour: v.literal('seen'),
} satisfies { readonly [name: string]: v.GenericSchema }

type SettingName = keyof typeof travels
export type HomeSettings = { readonly [name in SettingName]?: unknown }
export const settingNames = Object.keys(travels) as readonly SettingName[]

/** Where settings lie: texts by name. */
export interface Drawer {
  get(name: string): string | null
  put(name: string, text: string): void
}

/** What became of the settings of a home file: new here, or left out because this device has its own. */
interface MergedSettings {
  readonly taken: readonly SettingName[]
  readonly kept: readonly SettingName[]
}

/** The language is written as it is, all others as JSON. */
const reads = (name: string, text: string): unknown => (name === 'language' ? text : JSON.parse(text))
const writes = (name: string, value: unknown) => (name === 'language' ? String(value) : JSON.stringify(value))

/** Those that may be taken over: of a setting that is not one, nothing is left. */
export function readSettings(data: unknown): HomeSettings {
  const found = v.safeParse(v.record(v.string(), v.unknown()), data)
  if (!found.success) return {}
  const { output } = found
  return Object.fromEntries(
    settingNames.flatMap((name) => {
      const value = Object.hasOwn(output, name) ? v.safeParse(travels[name], output[name]) : null
      return value?.success ? [[name, value.output]] : []
    }),
  )
}

/** All that is set here. */
export function settingsIn(drawer: Drawer): HomeSettings {
  const all = settingNames.flatMap((name) => {
    const text = drawer.get(name)
    try {
      return text === null ? [] : [[name, reads(name, text)]]
    } catch {
      return []
    }
  })
  return readSettings(Object.fromEntries(all))
}

/** Takes over what is not set here yet. @throws what the drawer throws when it is full */
export function mergeSettings(drawer: Drawer, settings: HomeSettings): MergedSettings {
  const names = settingNames.filter((name) => settings[name] !== undefined)
  const taken = names.filter((name) => drawer.get(name) === null)
  const kept = names.filter((name) => {
    const here = drawer.get(name)
    return here !== null && here !== writes(name, settings[name])
  })
  for (const name of taken) drawer.put(name, writes(name, settings[name]))
  return { taken, kept }
}

/** This device's. Where it refuses, nothing is set. */
export const deviceDrawer: Drawer = {
  get(name) {
    try {
      return localStorage.getItem(`botgarten.${name}`)
    } catch {
      return null
    }
  },
  put: (name, text) => localStorage.setItem(`botgarten.${name}`, text),
}

/** Lets the page that is open follow settings that have just come. */
export function follow({ taken }: MergedSettings, settings: HomeSettings): void {
  const wishes = taken.includes('comfort') ? (settings.comfort as object) : {}
  for (const [name, on] of Object.entries(wishes)) if (on === true) comfort.set(name as 'quiet', true)
  if (taken.includes('language')) void language.speak(settings.language as Locale)
}
