import { readSetting, writeSetting } from '#storage/settings.ts'
import type { Scale } from '#drawing/track.ts'

/** starter: weights 0 to 1 · explorer: below 0 too, biases, hidden layers · expert: wider weights, activations, the formula. */
export const levels = ['starter', 'explorer', 'expert'] as const
type Name = (typeof levels)[number]

/** For whom the playground shows its controls, on this device. It never changes what a net does. */
class Level {
  #name = $state<Name>(readSetting('network-level', 'starter'))
  #tens = $state<boolean>(readSetting('network-tens', false))

  get name() {
    return this.#name
  }
  set name(name) {
    this.#name = name
    writeSetting('network-level', name)
  }
  get deep() {
    return this.#name !== 'starter'
  }

  /** Are knobs counted from 0 to 10? */
  get tens() {
    return this.#tens && !this.deep
  }
  set tens(on) {
    this.#tens = on
    writeSetting('network-tens', on)
  }

  get scale(): Scale {
    const most = this.#name === 'expert' ? 3 : 1
    return { least: this.deep ? -most : 0, most, unit: this.tens ? 10 : 1 }
  }
}

export const level = new Level()
