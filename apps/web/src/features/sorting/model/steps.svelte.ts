import { firstWork, othersIn, read, written } from './kept.ts'
import { isFresh, isSame, type Source, type Work } from './work.ts'
import type { Store } from './store.svelte.ts'

/** So many steps lead back. */
const LONGEST = 400

/** The line of steps that leads back, and the store on which the one that is shown is kept. */
export class Steps {
  readonly store: Store
  /** A newer Botgarten has left something here, or it is broken: it stays as it is until something is changed. */
  readonly unread: boolean
  #line = $state.raw<readonly Work[]>([])
  #at = $state(0)
  /** The data sets that are not displayed; the last displayed one is the last. */
  #left = $state.raw<readonly Work[]>([])
  #unkept = false
  /** What the step that is shown is still open for: a drag, letters of a name, readings of a drive. */
  #open: string | null = null

  constructor(store: Store) {
    this.store = store
    const work = read(store.kept)
    this.unread = work === null && store.kept !== null
    this.#line = [work ?? firstWork()]
    this.#left = othersIn(store.kept)
  }

  get work(): Work {
    return this.#line[this.#at]!
  }

  get at(): number {
    return this.#at
  }

  get last(): number {
    return this.#line.length - 1
  }

  /** The step before, where only sorting lies between. */
  get sortedFrom(): Work | null {
    const before = this.#line[this.#at - 1]
    return before?.table === this.work.table && !isFresh(this.work) ? before : null
  }

  add(work: Work): void {
    this.#open = null
    this.#line = [...this.#line.slice(Math.max(0, this.#at + 2 - LONGEST), this.#at + 1), work]
    this.#at = this.#line.length - 1
  }

  /** The step that is shown becomes another; what came after it is gone. */
  replace(work: Work): void {
    this.#line = this.#line.with(this.#at, work).slice(0, this.#at + 1)
  }

  /** A step that stays open: all that is extended by one hand in one go is one step. Returns whether it is a new one. */
  extend(work: Work, by: string): boolean {
    const isNew = this.#open !== by
    if (isNew) this.add(work)
    else this.replace(work)
    this.#open = by
    return isNew
  }

  isOpenFor(what: string): boolean {
    return this.#open === what
  }

  end(): void {
    this.#open = null
  }

  goTo(at: number): void {
    this.end()
    this.#at = Math.max(0, Math.min(this.last, at))
  }

  /** The data set that is shown is found again as it is. */
  leave(): void {
    this.#left = [...this.#left.filter((one) => !isSame(one, this.work)), this.work]
  }

  /** A data set as it was left; without a name the last displayed one of the source. */
  leftOn(source: Source, set?: string): Work | undefined {
    return this.#left.findLast((one) => one.source === source && (set === undefined || one.set === set))
  }

  /** @param later a moment of playing is not worth a record: `flush` writes it where nothing else does */
  keep(later: boolean): void {
    this.#unkept = true
    if (!later) this.#write()
  }

  /** The page is hidden, or left without a farewell. */
  flush(): void {
    if (this.#unkept) this.#write()
    this.store.flush()
  }

  #write(): void {
    this.store.keep(() => written(this.work, this.#left))
    this.#unkept = false
  }
}
