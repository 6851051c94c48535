import type { NeuronOutline, NetworkOutline } from '@botgarten/programs'
import type { RobotConfig } from '@botgarten/simulation'
import { partOf, type Part } from '#figures/highlight.svelte.ts'
import { readSetting, writeSetting } from '#storage/settings.ts'

/** What the tour shows: a neuron that drives a wheel. */
export interface Sight {
  readonly neuron: NeuronOutline
  readonly wheel: Part
  readonly side: 'left' | 'right'
}

/** The first neuron of a network that drives a wheel; null where none does: there is no tour then. */
export function sightOf(net: NetworkOutline | null, { drive }: RobotConfig): Sight | null {
  for (const neuron of net?.outputs ?? []) {
    const wheel = partOf(neuron)
    if (wheel === `motor ${drive.left}`) return { neuron, wheel, side: 'left' }
    if (wheel === `motor ${drive.right}`) return { neuron, wheel, side: 'right' }
  }
  return null
}

/** Where the tour is: null it is not on the screen, −1 it is offered, else which move is next. It is offered once on a device. */
export class Guide {
  #move = $state(readSetting<unknown>('tour', null) === 'seen' ? null : -1)
  #reached = $state(-1)

  get move() {
    return this.#move
  }

  /** True once the part that this move asks for was touched, even if another part is touched afterwards. */
  get isReached() {
    return this.#move !== null && this.#reached >= this.#move
  }

  /** The child has touched the part that this move asks for. */
  reach(): void {
    this.#reached = Math.max(this.#reached, this.#move ?? -1)
  }

  go(move: number): void {
    this.#move = move
  }

  close(): void {
    this.#move = null
    writeSetting('tour', 'seen')
  }
}
