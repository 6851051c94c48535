import type { Item } from '#figures/gallery/item.ts'
import type { Ask } from '#storage/ask.ts'
import { fetchPage, fetchShared, giveHeart, takeOut, type Opened, type Order, type Problem } from './api.ts'

/** In ms: what a class does within this is looked at once. */
const pause = 1000
/** So much of a long list is looked at again. */
const mostAgain = 120

/** The gallery as a page shows it: a list that grows, and one thing that is looked at. */
export class Gallery {
  readonly #ask: Ask
  #order = $state<Order>('newest')
  #items = $state.raw<readonly Item[] | null>(null)
  #total = $state(0)
  #fetched = 0
  #opened = $state.raw<Opened | null>(null)
  #wanted: string | null = null
  #problem = $state<Problem | null>(null)
  #isSoon = false

  constructor(ask: Ask) {
    this.#ask = ask
  }

  get order() {
    return this.#order
  }
  /** Null until they are there. */
  get items() {
    return this.#items
  }
  get total() {
    return this.#total
  }
  get hasMore() {
    return this.#items !== null && this.#fetched < this.#total
  }
  get opened() {
    return this.#opened
  }
  get problem() {
    return this.#problem
  }

  async show(order: Order = this.#order): Promise<void> {
    this.#order = order
    this.#fetched = 0
    await this.#fetch([])
  }

  more = (): Promise<void> => this.#fetch(this.#items ?? [])

  async #fetch(before: readonly Item[]): Promise<void> {
    const order = this.#order
    const page = await fetchPage(this.#ask, order, this.#fetched)
    if (order !== this.#order) return
    if (typeof page === 'string') return this.#fail(page)
    this.#problem = null
    this.#fetched += page.items.length
    // Nothing more comes where the list has become shorter meanwhile.
    this.#total = page.items.length === 0 ? this.#fetched : page.total
    const isNew = ({ id }: Item) => !before.some((one) => one.id === id)
    this.#items = [...before, ...page.items.filter(isNew)]
  }

  /** Somebody has done something: the list is looked at again soon. */
  lookSoon = (): void => {
    if (this.#isSoon) return
    this.#isSoon = true
    setTimeout(() => {
      this.#isSoon = false
      void this.#again()
    }, pause)
  }

  async #again(): Promise<void> {
    const order = this.#order
    const until = Math.min(this.#fetched, mostAgain)
    if (this.#items === null) return
    const fresh: Item[] = []
    let page: Awaited<ReturnType<typeof fetchPage>>
    do {
      page = await fetchPage(this.#ask, order, fresh.length)
      if (order !== this.#order) return
      if (typeof page === 'string') return this.#fail(page)
      fresh.push(...page.items)
    } while (page.items.length > 0 && fresh.length < until)
    this.#takeFresh(fresh, page.total, until)
  }

  #takeFresh(fresh: readonly Item[], total: number, until: number): void {
    const all = [...fresh, ...(this.#items ?? []).slice(until)]
    // What comes twice because something was shared meanwhile stands there once.
    this.#items = all.filter(({ id }, at) => all.findIndex((one) => one.id === id) === at)
    this.#fetched = this.#items.length
    this.#total = total
    const now = fresh.find(({ id }) => id === this.#opened?.id)
    if (this.#opened && now) this.#opened = { ...this.#opened, hearts: now.hearts, mine: now.mine }
  }

  #fail(problem: Problem): void {
    this.#problem = problem
    if (problem === 'off') this.#items = null
  }

  async look(id: string): Promise<void> {
    this.#wanted = id
    const opened = await fetchShared(this.#ask, id)
    if (this.#wanted !== id) return
    this.#problem = typeof opened === 'string' ? opened : null
    this.#opened = typeof opened === 'string' ? null : opened
    if (opened === 'gone') void this.show()
  }

  close = (): void => {
    this.#wanted = null
    this.#opened = null
  }

  async heart({ id, mine }: Pick<Item, 'id' | 'mine'>): Promise<void> {
    const given = await giveHeart(this.#ask, id, !mine)
    if (typeof given === 'string') return this.#fail(given)
    const changed = <One extends Item>(one: One): One => (one.id === id ? { ...one, ...given } : one)
    this.#items = this.#items?.map(changed) ?? null
    this.#opened &&= changed(this.#opened)
  }

  async takeOut(id: string): Promise<void> {
    const problem = await takeOut(this.#ask, id)
    if (problem !== null && problem !== 'gone') return this.#fail(problem)
    this.close()
    await this.show()
  }
}
