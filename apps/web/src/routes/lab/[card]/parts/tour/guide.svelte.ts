import { readSetting, writeSetting } from '#lib/storage/settings.ts'

/** Is the tour on the screen? It is offered once on a device, and comes again when it is asked for. */
export class Guide {
  #open = $state(readSetting<unknown>('tour', null) !== 'seen')
  #asked = $state(false)

  get open() {
    return this.#open
  }
  get asked() {
    return this.#asked
  }

  again(): void {
    this.#open = true
    this.#asked = true
  }

  close(): void {
    this.#open = false
    this.#asked = false
    writeSetting('tour', 'seen')
  }
}
