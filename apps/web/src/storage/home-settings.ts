import { comfort } from './comfort.svelte.ts'
import { language, type Locale } from '#words/language.svelte.ts'
import * as v from 'valibot'
import { placeOfSetting, settings as travels } from './settings.ts'

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
  const joined = joinRobots(drawer, settings)
  return { taken, kept: joined ? kept.filter((name) => name !== 'robots') : kept }
}

/** Robots of both stay, under a name that both have this device's. True where there were some here. */
function joinRobots(drawer: Drawer, { robots }: HomeSettings): boolean {
  const { robots: own } = settingsIn(drawer)
  if (typeof own !== 'object' || typeof robots !== 'object') return false
  drawer.put('robots', JSON.stringify({ ...own, ...robots, ...own }))
  return true
}

/** This device's. Where it refuses, nothing is set. */
export const deviceDrawer: Drawer = {
  get(name) {
    try {
      return localStorage.getItem(placeOfSetting(name))
    } catch {
      return null
    }
  },
  put: (name, text) => localStorage.setItem(placeOfSetting(name), text),
}

/** Lets the page that is open follow settings that have just come. */
export function follow({ taken }: MergedSettings, settings: HomeSettings): void {
  const options = taken.includes('comfort') ? (settings.comfort as object) : {}
  for (const [name, on] of Object.entries(options)) if (on === true) comfort.set(name as 'quiet', true)
  if (taken.includes('language')) void language.speak(settings.language as Locale)
}
