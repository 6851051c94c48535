import { untrack } from 'svelte'
import { calm } from '#drawing/calm.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { m } from '#words/message.ts'
import { language } from '#words/language.svelte.ts'
import type { Variable } from '@botgarten/lab'
import { noValues, valuesAtBlocks, type ValueWords } from './values.ts'

/** A child that looks closely: where the run stops, and what the program remembers. */
export class Debugger {
  readonly #session: LabSession
  #stops = $state.raw<readonly string[]>([])
  #variables = $state.raw<readonly Variable[]>([])
  #open = $state(true)

  constructor(session: LabSession) {
    this.#session = session
  }

  get open() {
    return this.#open
  }
  /** A run stops only while the stops are seen. */
  set open(open: boolean) {
    this.#open = open
    this.#session.lab.setStops(this.#seen)
  }

  get #seen(): readonly string[] {
    return this.#open ? this.#stops : []
  }

  /** Looks at the variables from now on, while the component lives that calls this. */
  watch(): void {
    const turn = calm(6)
    $effect.pre(() => {
      const { phase } = this.#session.lab.view
      const robot = this.#session.robotId
      if (turn(performance.now(), phase === 'running'))
        this.#variables = untrack(() => this.#session.lab.variables(robot))
    })
  }

  get stops() {
    return this.#stops
  }
  get variables() {
    return this.#variables
  }

  get words(): ValueWords {
    return { locale: language.locale, yes: m['debug.true'](), no: m['debug.false']() }
  }

  /** What is drawn at blocks; values only while a run is on. */
  readonly marks = $derived.by(() => {
    const { phase } = this.#session.lab.facts
    const on = this.#open && (phase === 'running' || phase === 'paused')
    const values = on ? valuesAtBlocks(this.#session.program, this.#variables, this.words) : noValues
    return { stops: this.#seen, values }
  })

  /** Does the run wait at a stop? */
  get waits(): boolean {
    const { phase, robots } = this.#session.lab.view
    return phase === 'paused' && robots.some(({ lit }) => lit !== null && this.#stops.includes(lit))
  }

  toggleStop(block: string): void {
    const without = this.#stops.filter((id) => id !== block)
    this.#stops = without.length < this.#stops.length ? without : [...this.#stops, block]
    this.#session.lab.setStops(this.#seen)
  }
}
