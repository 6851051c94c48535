import { backedUp, clock, findings, sizes, type Clock, type Finding } from './answers.ts'
import type { ClassApi } from './api.ts'
import { Attempts } from './attempts.svelte.ts'

/** In ms: so often it is asked again. */
const every = 10_000

/** What classes take on the server. */
interface Sizes {
  readonly classes: number
  readonly pupils: number
  /** Bytes. */
  readonly space: number
}

/** How the server is, in the doctor's words; for who runs it also how much lies on it. */
export class ServerHealth {
  readonly #api: ClassApi
  readonly #attempts = new Attempts()
  #findings = $state.raw<readonly Finding[] | null>(null)
  #sizes = $state.raw<Sizes | null>(null)
  #clock = $state.raw<Clock | null>(null)
  #saving = $state(false)

  constructor(api: ClassApi) {
    this.#api = api
  }

  /** What needs somebody comes first; null: it is being asked. */
  get findings(): readonly Finding[] | null {
    return this.#findings
  }

  get sizes(): Sizes | null {
    return this.#sizes
  }

  /** The question about the clock; null while it is not doubted, and for teachers who are not the operator. */
  get clock(): Clock | null {
    return this.#clock
  }

  get refused(): string | null {
    return this.#attempts.refused
  }

  get saving(): boolean {
    return this.#saving
  }

  /** @param operates is the teacher who asks the operator of the server? */
  async look(operates: boolean): Promise<void> {
    const all = await this.#attempts.try(() => this.#api.ask(findings, 'GET', '/findings'))
    if (all) this.#findings = all.findings.toSorted((one, other) => Number(one.fine) - Number(other.fine))
    if (!operates) return
    await this.#measure()
    const found = await this.#attempts.try(() => this.#api.ask(clock, 'GET', '/clock'))
    if (found) this.#clock = found.doubted ? found : null
  }

  async #measure(): Promise<void> {
    const found = await this.#attempts.try(() => this.#api.ask(sizes, 'GET', '/sizes'))
    const sum = (key: 'pupils' | 'space') => found?.classes.reduce((all, one) => all + one[key], 0) ?? 0
    if (found) this.#sizes = { classes: found.classes.length, pupils: sum('pupils'), space: sum('space') }
  }

  /** Looks now and again. Returns how to stop. */
  watch(operates: boolean): () => void {
    void this.look(operates)
    const timer = setInterval(() => document.visibilityState === 'visible' && void this.look(operates), every)
    return () => clearInterval(timer)
  }

  /** Answers whether the clock is right. Then ended classes are deleted, or else shown again. */
  async answer(right: boolean): Promise<void> {
    const today = this.#clock?.today
    if (await this.#attempts.do(() => this.#api.send('POST', '/clock', { right, today })))
      await this.look(true)
  }

  /** Makes the copy of today. */
  async backUp(): Promise<void> {
    this.#saving = true
    const saved = await this.#attempts.do(() => this.#api.ask(backedUp, 'POST', '/backup'))
    this.#saving = false
    if (saved) await this.look(true)
  }
}
