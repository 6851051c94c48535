import { ExamplesError, joinExamples, roomBehind } from '@botgarten/programs/examples'
import type { Examples } from '@botgarten/learning/neural-network/examples'
import {
  chosenColumns,
  inColumns,
  readExamples,
  type Help,
  type Helps,
  type LooseTable,
  type Read,
  type Refused,
} from './files.ts'
import type { Showing } from './showing.svelte.ts'

/** What has come of a file. */
export type Opened = Taken | Refused

interface Taken {
  readonly kind: 'opened'
  readonly examples: Examples
  /** So many rows of it there was room for. */
  readonly count: number
  /** Numbers beyond what sensors read and wheels can do. */
  readonly outside: number
  /** Are there others before them? */
  readonly isMixed: boolean
}

/** Opens examples from a file: behind those that are there, or in their place. What is wrong with it can be helped. */
export class Opening {
  readonly #showing: Showing
  #file: File | null = null
  #helps: Helps = {}
  #loose = $state.raw<LooseTable | null>(null)
  #result = $state.raw<Opened | null>(null)

  constructor(showing: Showing) {
    this.#showing = showing
  }

  /** A table whose columns have to be put to neurons. */
  get loose() {
    return this.#loose
  }
  get result() {
    return this.#result
  }
  open(file: File): Promise<void> {
    this.#file = file
    this.#helps = {}
    return this.#read()
  }

  /** The file again, with this help. */
  accept(help: Help): Promise<void> {
    this.#helps = { ...this.#helps, [help]: true }
    return this.#read()
  }

  async #read(): Promise<void> {
    const { net } = this.#showing
    if (this.#file && net) this.#take(await readExamples(this.#file, net, this.#helps))
  }

  /** The columns of the table are these neurons'. */
  async put(chosen: readonly (readonly [neuron: string, column: number])[]): Promise<void> {
    const { net } = this.#showing
    if (this.#loose && net) this.#take(await inColumns(chosenColumns(this.#loose, chosen), net, this.#helps))
  }

  cancel(): void {
    this.#loose = null
  }

  #take(read: Read): void {
    this.#loose = read.kind === 'columns' ? read.table : null
    if (read.kind === 'refused') this.#result = read
    else if (read.kind === 'examples') this.#add(read)
  }

  #add({ examples, outside }: Read & { kind: 'examples' }): void {
    const { net, session } = this.#showing
    const before = this.#showing.examples
    if (!net) return
    try {
      const all = before ? joinExamples(before, examples, this.#helps.first) : examples
      session.examples.replace(net.id, all)
      const had = before?.rows.length ?? 0
      const count = all.rows.length - had
      this.#result = { kind: 'opened', examples, count, outside, isMixed: had > 0 }
    } catch (error) {
      if (!(error instanceof ExamplesError)) throw error
      const { problem, facts } = error
      const count = before ? roomBehind(before) : 0
      const refused: Refused = { kind: 'refused', problem, facts }
      this.#result = count > 0 ? { ...refused, offer: { help: 'first', count } } : refused
    }
  }

  /** Those that were there before go. */
  onlyThese(): void {
    const { net, session } = this.#showing
    if (net && this.#result?.kind === 'opened') session.examples.replace(net.id, this.#result.examples)
    this.#result = null
  }
}
