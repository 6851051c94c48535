import { findingsIn } from '@botgarten/learning/neural-network/examples'
import type { Order, Report } from './messages.ts'
import { Practiser } from './practiser.ts'

/** Milliseconds between two reports: nobody sees more than 20 a second. */
const between = 50
/** Milliseconds of work before the first one: who has pressed waits for it. */
const beforeFirst = 2

export interface Surroundings {
  /** Milliseconds. */
  now(): number
  /** Does something after so many ms; what has arrived meanwhile is taken first. */
  later(act: () => void, ms: number): void
  post(report: Report): void
  /** Milliseconds that a slice may take. */
  readonly slice: number
}

/** Carries orders out, a slice at a time: in a worker, or where the page runs. */
export class Host {
  readonly #around: Surroundings
  #practiser: Practiser | null = null
  #isDue = false
  #posted = -Infinity
  /** A report is on its way: the page gets no more than it can take in. */
  #isUnheard = false

  constructor(around: Surroundings) {
    this.#around = around
  }

  take(order: Order): void {
    if (order.kind === 'heard') {
      this.#isUnheard = false
      return
    }
    if (order.kind === 'begin') {
      this.#practiser = new Practiser(order.job, order.exercise, order.settings)
      this.#posted = -Infinity
      this.#isUnheard = false
      return
    }
    if (order.kind === 'ask') {
      const { number, table } = order
      this.#around.post({ kind: 'answer', number, findings: findingsIn(table) })
      return
    }
    const practiser = this.#practiser
    if (!practiser) return
    if (order.kind === 'peek' || order.kind === 'step') {
      const example = practiser.example(order.kind === 'peek')
      if (example) this.#around.post(example)
      if (!example || practiser.hasNews) this.#post(practiser)
      return
    }
    if (order.kind === 'go') practiser.go(order.until, order.pace, this.#around.now())
    else practiser.stop()
    if (practiser.isDone) this.#post(practiser)
    else this.#workLater(0)
  }

  #workLater(ms: number): void {
    if (this.#isDue) return
    this.#isDue = true
    this.#around.later(this.#work, ms)
  }

  #work = (): void => {
    this.#isDue = false
    const practiser = this.#practiser
    if (!practiser || practiser.isDone) return
    const around = this.#around
    const now = () => around.now()
    const slice = this.#posted === -Infinity ? Math.min(beforeFirst, around.slice) : around.slice
    practiser.work(now, now() + slice)
    const isRipe = practiser.hasMoved && !this.#isUnheard && now() - this.#posted >= between
    if (isRipe || practiser.isDone) this.#post(practiser)
    if (!practiser.isDone) this.#workLater(Math.min(between, practiser.wait(now())))
  }

  #post(practiser: Practiser): void {
    this.#posted = this.#around.now()
    this.#isUnheard = true
    this.#around.post(practiser.report())
  }
}
