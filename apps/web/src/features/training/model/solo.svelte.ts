import { level } from '#figures/network/level.svelte.ts'
import type { Assignment } from './assignment.svelte.ts'
import { driveAlone, unseenStarts, type Tried } from './alone.ts'

/** Milliseconds of a frame that driving without a picture takes. */
const budget = 6

/** What came of driving alone with a round. */
export interface Result {
  readonly round: number
  readonly tried: readonly Tried[]
}

/** Whose weights are on the knobs. */
interface Shown {
  readonly outcome: { readonly round: number }
}

/** Bo drives alone from starts that nobody has shown. */
export class Solo {
  readonly #assignment: Assignment & Shown
  #results = $state.raw<readonly Result[]>([])
  #isGoing = $state(false)
  #frame = 0
  /** The start that is looked at. */
  shown = $state.raw<Tried | null>(null)

  constructor(assignment: Assignment & Shown) {
    this.#assignment = assignment
  }

  /** The last two. */
  get results() {
    return this.#results
  }
  /** What Bo read where it failed in the last run. */
  readonly failed: readonly (readonly number[])[] = $derived.by(() =>
    (this.#results.at(-1)?.tried ?? []).flatMap(({ passed, readings }) =>
      passed || !readings ? [] : [readings],
    ),
  )
  get isGoing() {
    return this.#isGoing
  }
  get count() {
    return level.deep ? 12 : 4
  }

  go(): void {
    if (this.#isGoing) return
    const { session, outcome, net } = this.#assignment
    const { round } = outcome
    const { lab, opened, robotId } = session
    const { card } = opened
    const starts = unseenStarts(card?.card.starts ?? [], lab.document.world.size, this.count, 1)
    const checks = card?.card.checks ?? []
    const network = net && { id: net.id, inputs: net.inputs.map(({ id }) => id) }
    const course = { document: lab.document, floor: lab.floor, checks, robot: robotId, network }
    this.#isGoing = true
    this.shown = null
    this.#inFrames(driveAlone(course, starts), (tried) => {
      this.#isGoing = false
      const others = this.#results.filter((one) => one.round !== round)
      this.#results = [...others.slice(-1), { round, tried }]
    })
  }

  #inFrames(work: Generator<undefined, readonly Tried[]>, done: (tried: readonly Tried[]) => void): void {
    const pass = () => {
      const end = performance.now() + budget
      do {
        const { done: isDone, value } = work.next()
        if (isDone) return done(value)
      } while (performance.now() < end)
      this.#frame = requestAnimationFrame(pass)
    }
    this.#frame = requestAnimationFrame(pass)
  }

  close(): void {
    cancelAnimationFrame(this.#frame)
    this.#isGoing = false
    this.shown = null
  }
}
