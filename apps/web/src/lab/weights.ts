import {
  copyWeights,
  emptyBrain,
  weightsOf,
  withoutWeights,
  type Brain,
} from '@botgarten/learning/neural-network'
import type { RunningLab } from './running.svelte.ts'
import type { UndoStack } from './undo.svelte.ts'

type Phase = 'start' | 'move' | 'end'

/** What the weights belong to, and what has to happen round every change. */
interface Owner {
  readonly lab: RunningLab
  readonly undo: UndoStack
  /** Name of the set that the chosen robot drives with. */
  readonly set: () => string
  /** A moment of the past is the present from here on (running.md 9). */
  readonly goOn: () => void
  readonly changed: (change: () => void) => void
}

/** The weights of the chosen robot's networks in a child's hands. */
export class HandOnWeights {
  readonly #owner: Owner
  #before: Brain | null = null

  constructor(owner: Owner) {
    this.#owner = owner
  }

  #brain = (id: string): Brain => this.#owner.lab.document.brains[id] ?? emptyBrain

  /** Those that are shown: of the moment, in the set that the robot drives with. */
  shown(network: string) {
    const brain = this.#owner.lab.facts.brains[network]
    return brain ? weightsOf(brain, this.#owner.set()) : {}
  }

  /** Those of the present, whatever moment is shown. */
  now(network: string) {
    return weightsOf(this.#brain(network), this.#owner.set())
  }

  turn(network: string, from: string, to: string, weight: number, phase: Phase): void {
    const { lab, undo, set, goOn, changed } = this.#owner
    goOn()
    if (phase === 'start') this.#before = this.#brain(network)
    changed(() => lab.setWeight(network, from, to, weight, set()))
    const [before, after] = [this.#before, this.#brain(network)]
    if (phase === 'end' && before && before !== after)
      undo.note({ kind: 'brain', id: network, before, after })
  }

  reset(network: string): void {
    this.change(network, (brain) => withoutWeights(brain, this.#owner.set()))
  }

  /** Another brain in a network's place, as one step; the same one changes nothing. */
  change(network: string, change: (brain: Brain) => Brain): void {
    const { lab, undo, goOn, changed } = this.#owner
    goOn()
    const before = this.#brain(network)
    const after = change(before)
    if (after === before) return
    changed(() => lab.setBrain(network, after))
    undo.note({ kind: 'brain', id: network, before, after })
  }

  /** Duplicated neurons take the weights of their originals along. */
  copied(pairs: readonly { readonly from: string; readonly to: string }[]): void {
    const { lab, changed } = this.#owner
    for (const [id, brain] of Object.entries(lab.document.brains))
      changed(() => lab.setBrain(id, copyWeights(brain, pairs)))
  }
}
