import * as v from 'valibot'
import { item, looked, type Item, type Looked } from '#figures/gallery/item.ts'
import type { ClassApi } from './api.ts'
import { Attempts } from './attempts.svelte.ts'

export type Order = 'newest' | 'hearts' | 'waiting' | 'hidden'

const page = v.object({
  on: v.boolean(),
  asking: v.boolean(),
  together: v.boolean(),
  waiting: v.number(),
  total: v.number(),
  items: v.array(item),
})

/** Is there a gallery, may pupils ask each other, may two work on one program? */
type Switches = Pick<v.InferOutput<typeof page>, 'on' | 'asking' | 'together'>

/** The gallery of a class as its teacher sees it: what is shared, what waits for a yes, what is hidden. */
export class ClassGallery {
  readonly #api: ClassApi
  readonly #path: string
  readonly #attempts = new Attempts()
  #order = $state<Order>('newest')
  #page = $state.raw<v.InferOutput<typeof page> | null>(null)
  #items = $state.raw<readonly Item[]>([])
  #looked = $state.raw<Looked | null>(null)

  constructor(api: ClassApi, id: string) {
    this.#api = api
    this.#path = `/classes/${id}/gallery`
  }

  get order() {
    return this.#order
  }
  get items() {
    return this.#items
  }
  get looked() {
    return this.#looked
  }
  /** Null until it is there. */
  get settings() {
    return this.#page
  }
  get hasMore(): boolean {
    return this.#items.length < (this.#page?.total ?? 0)
  }
  get refused() {
    return this.#attempts.refused
  }

  async show(order: Order = this.#order): Promise<void> {
    this.#order = order
    await this.#fetch([])
  }
  more = (): Promise<void> => this.#fetch(this.#items)

  async #fetch(before: readonly Item[]): Promise<void> {
    const order = this.#order
    const query = `?by=${order}&from=${before.length}`
    const next = await this.#attempts.try(() => this.#api.ask(page, 'GET', this.#path + query))
    if (!next || order !== this.#order) return
    const isNew = ({ id }: Item) => !before.some((one) => one.id === id)
    const items = [...before, ...next.items.filter(isNew)]
    // Nothing more comes where the list has become shorter meanwhile.
    this.#page = { ...next, total: next.items.length === 0 ? items.length : next.total }
    this.#items = items
  }

  set = (change: Partial<Switches>): Promise<void> => this.#do(this.#path, change)
  hide = (id: string, hidden: boolean): Promise<void> => this.#do(`${this.#path}/${id}`, { hidden })
  allow = (id: string): Promise<void> => this.#do(`${this.#path}/${id}`, { allowed: true })

  async #do(path: string, body: object): Promise<void> {
    const done = await this.#attempts.do(() => this.#api.send('PUT', path, body))
    this.close()
    if (done) await this.show()
  }

  async look(id: string): Promise<void> {
    this.#looked = await this.#attempts.try(() => this.#api.ask(looked, 'GET', `${this.#path}/${id}`))
  }
  close = (): void => {
    this.#looked = null
  }
}
