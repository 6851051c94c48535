import { apply } from './apply.ts'
import { beginning, copyOf, type State } from './state.ts'
import type { Author, Entry, Operation, Shared } from './types.ts'
import { backFrom, undoesOwn, type Back } from './undo.ts'

/** One of the two ends: what is certain, and on it what the other end has not got yet. */
export class Peer {
  readonly author: Author
  #confirmed: State
  #length = 0
  /** The own count of the last entry in the common order, and of the last that was made. */
  #sent = 0
  #made = 0
  #pending: readonly Entry[]
  #view: State

  /** @param pending what this end has made and not yet seen in the common order */
  constructor(author: Author, shared: Shared, pending: readonly Entry[] = []) {
    this.author = author
    this.#confirmed = beginning(shared)
    this.#pending = pending
    this.#made = pending.at(-1)?.n ?? 0
    this.#view = this.#confirmed
    this.#rebase()
  }

  /** The program as it is seen here. */
  get shared(): Shared {
    return this.#view.doc
  }
  /** How many entries of the common order are known. */
  get length(): number {
    return this.#length
  }
  get pending(): readonly Entry[] {
    return this.#pending
  }

  /** Does something here. Returns what takes it back, the last first. */
  edit(ops: readonly Operation[]): readonly Back[] {
    const backs = ops.map((op) => {
      const back = backFrom(op, this.#view, this.#length)
      const entry = { by: this.author, n: ++this.#made, base: this.#length, op }
      this.#pending = [...this.#pending, entry]
      this.#try(entry)
      return back
    })
    return backs.filter((back) => back !== null).reverse()
  }

  /** Takes own operations back, but for what the other one has gone on from. Returns what does them again. */
  undo(backs: readonly Back[]): readonly Back[] {
    return backs
      .flatMap((back) => (undoesOwn(back, this.#view, this.author) ? this.edit([back.op]) : []))
      .reverse()
  }

  /** Takes in entries of the common order from this place on; what is known already is left out. */
  receive(from: number, entries: readonly Entry[]): void {
    if (from > this.#length) throw new RangeError('entries are missing')
    for (const entry of entries.slice(this.#length - from)) {
      apply(this.#confirmed, entry, this.#length++)
      if (entry.by === this.author) this.#sent = Math.max(this.#sent, entry.n)
    }
    this.#pending = this.#pending.filter(({ n }) => n > this.#sent)
    this.#made = Math.max(this.#made, this.#sent)
    this.#rebase()
  }

  #rebase(): void {
    this.#view = copyOf(this.#confirmed)
    for (const entry of this.#pending) this.#try(entry)
  }

  /** As if it were the next one. */
  #try(entry: Entry): void {
    apply(this.#view, entry, Number.MAX_SAFE_INTEGER)
  }
}
