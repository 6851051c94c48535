import * as v from 'valibot'
import { settings } from './setting-shapes.ts'

/** A setting of this device, or the preset where the browser keeps nothing, or something that is no such setting. */
export function readSetting<Value>(name: string, preset: Value): Value {
  try {
    const text = localStorage.getItem(`botgarten.${name}`)
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
    localStorage.setItem(`botgarten.${name}`, JSON.stringify(value))
  } catch {
    // A device that keeps nothing shows its presets the next time; there is nothing to lose.
  }
}
