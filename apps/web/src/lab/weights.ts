import {
  copyWeights,
  emptyBrain,
  weightsOf,
  withoutWeights,
  type Brain,
} from '@botgarten/learning/neural-network/brain'
import type { Part } from './change.ts'
import type { LabSession } from './session.svelte.ts'

/** The weights of the chosen robot's networks in a child's hands. */
export class HandOnWeights {
  readonly #session: Pick<LabSession, 'apply' | 'goOn' | 'lab' | 'robot'>

  constructor(session: Pick<LabSession, 'apply' | 'goOn' | 'lab' | 'robot'>) {
    this.#session = session
  }

  #brain = (id: string): Brain => this.#session.lab.document.brains[id] ?? emptyBrain
  /** Name of the set that the chosen robot drives with. */
  get #set() {
    return this.#session.robot.brain
  }

  /** Those that are shown: of the moment, in the set that the robot drives with. */
  shown(network: string) {
    const brain = this.#session.lab.facts.brains[network]
    return brain ? weightsOf(brain, this.#set) : {}
  }

  /** Those of the present, whatever moment is shown. */
  now(network: string) {
    return weightsOf(this.#brain(network), this.#set)
  }

  turn(network: string, from: string, to: string, after: number, part: Part): void {
    this.#session.apply({ kind: 'weight', network, from, to, after, set: this.#set }, part)
  }

  reset(network: string): void {
    this.change(network, (brain) => withoutWeights(brain, this.#set))
  }

  /** Another brain in a network's place, as one step; the same one changes nothing. */
  change(network: string, change: (brain: Brain) => Brain): void {
    this.#session.goOn()
    const before = this.#brain(network)
    const after = change(before)
    if (after !== before) this.#session.apply({ kind: 'brain', id: network, after })
  }

  /** Duplicated neurons take the weights of their originals along. */
  copied(pairs: readonly { readonly from: string; readonly to: string }[]): void {
    for (const [id, brain] of Object.entries(this.#session.lab.document.brains))
      this.#session.apply({ kind: 'brain', id, after: copyWeights(brain, pairs) }, 'silent')
  }
}
