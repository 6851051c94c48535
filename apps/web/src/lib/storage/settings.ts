/** A setting of this device, or the preset where the browser keeps nothing. */
export function readSetting<Value>(name: string, preset: Value): Value {
  try {
    const text = localStorage.getItem(`botgarten.${name}`)
    return text === null ? preset : (JSON.parse(text) as Value)
  } catch {
    return preset
  }
}

export function writeSetting(name: string, value: unknown): void {
  try {
    localStorage.setItem(`botgarten.${name}`, JSON.stringify(value))
  } catch {
    // A device that keeps nothing shows its presets the next time; there is nothing to lose.
  }
}
