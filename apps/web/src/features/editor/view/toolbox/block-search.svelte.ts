import type { Category } from '@botgarten/blocks'
import type { WorkspaceSvg } from 'blockly/core'
import { message } from '#words/message.ts'
import { matching, offersOn, type Offer } from './offers.ts'

/** How far a key moves in a list of `count` hits; PageUp and PageDown stop at its ends. */
const steps: { readonly [key: string]: (at: number, count: number) => number } = {
  ArrowDown: (at) => at + 1,
  ArrowUp: (at) => at - 1,
  PageDown: (at, count) => Math.min(at + 6, count - 1),
  PageUp: (at) => Math.max(at - 6, 0),
}

/** A search for a block: what is looked for, what is found, and which hit the keys are at. */
export class BlockSearch {
  #workspace: WorkspaceSvg
  readonly #families: readonly Category[] | null
  #offers: readonly Offer[]
  #query = $state('')
  #at = $state(0)
  readonly hits = $derived.by(() => matching(this.#offers, this.#query))

  /** `all`: the toolbox shows every block. `families`: of these alone; null: of all. */
  constructor(workspace: WorkspaceSvg, all: boolean, families: readonly Category[] | null = null) {
    this.#workspace = workspace
    this.#families = families
    this.#offers = $state.raw(this.#offersOn(all))
  }

  get query(): string {
    return this.#query
  }

  /** What is looked for, without spaces around it; empty: nothing yet. */
  get asked(): string {
    return this.#query.trim()
  }

  /** Index of the hit that Enter takes. */
  get at(): number {
    return this.#at
  }

  ask(query: string): void {
    this.#query = query
    this.#at = 0
  }

  /** Looks among the blocks of the toolbox that shows every block from now on. */
  lookInAll(): void {
    this.#offers = this.#offersOn(true)
  }

  #offersOn(all: boolean): readonly Offer[] {
    const offers = offersOn(this.#workspace, all, message)
    return offers.filter(({ category }) => this.#families?.includes(category) ?? true)
  }

  /** Goes to another hit. Returns whether the key means one; arrows lead from the last to the first. */
  moves(key: string): boolean {
    const count = this.hits.length
    const step = steps[key]
    if (!step || count === 0) return false
    this.#at = (step(this.#at, count) + count) % count
    return true
  }
}
