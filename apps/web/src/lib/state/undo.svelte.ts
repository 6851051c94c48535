import type { Brain } from '@botgarten/learning/neural-network'
import type { Pose } from '@botgarten/simulation'

/** One step over the document. Blocks are taken back by Blockly, which keeps what changed. */
export type Step =
  | { readonly kind: 'blocks' }
  | { readonly kind: 'place'; readonly id: string; readonly before: Pose; readonly after: Pose }
  | { readonly kind: 'brain'; readonly id: string; readonly before: Brain; readonly after: Brain }

/** Who carries a step out, in either direction. */
export interface Hands {
  /** @returns whether it happened: not while a hand holds a block */
  blocks(direction: 'undo' | 'redo'): boolean
  place(id: string, pose: Pose): void
  brain(id: string, brain: Brain): void
}

const LONGEST = 500

/** One stack over blocks, world and weights (running.md 9). */
export class UndoStack {
  #done = $state.raw<readonly Step[]>([])
  #undone = $state.raw<readonly Step[]>([])
  #hands: Hands

  constructor(hands: Hands) {
    this.#hands = hands
  }

  get canUndo() {
    return this.#done.length > 0
  }
  get canRedo() {
    return this.#undone.length > 0
  }

  note(step: Step): void {
    this.#done = [...this.#done, step].slice(-LONGEST)
    this.#undone = []
  }

  undo(): void {
    const step = this.#done.at(-1)
    if (!step || !this.#carryOut(step, 'undo')) return
    this.#done = this.#done.slice(0, -1)
    this.#undone = [...this.#undone, step]
  }

  redo(): void {
    const step = this.#undone.at(-1)
    if (!step || !this.#carryOut(step, 'redo')) return
    this.#undone = this.#undone.slice(0, -1)
    this.#done = [...this.#done, step]
  }

  #carryOut(step: Step, direction: 'undo' | 'redo'): boolean {
    if (step.kind === 'blocks') return this.#hands.blocks(direction)
    const value = direction === 'undo' ? step.before : step.after
    if (step.kind === 'place') this.#hands.place(step.id, value as Pose)
    else this.#hands.brain(step.id, value as Brain)
    return true
  }
}
