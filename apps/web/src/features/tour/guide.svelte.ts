import { readSetting, writeSetting } from '#storage/settings.ts'

/** Where the tour is: null it is not on the screen, −1 it is offered, else which move is next. It is offered once on a device. */
export class Guide {
  #move = $state(readSetting<unknown>('tour', null) === 'seen' ? null : -1)

  get move() {
    return this.#move
  }

  go(move: number): void {
    this.#move = move
  }

  close(): void {
    this.#move = null
    writeSetting('tour', 'seen')
  }
}
