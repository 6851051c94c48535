import type { Wheels } from '@botgarten/lab'
import type { Drive, Examples } from '@botgarten/learning/neural-network/examples'
import { choiceIn, wheelsIn } from '@botgarten/programs/examples'
import type { LabEvent } from '#lab/change.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import type { Assignment } from './assignment.svelte.ts'
import { asShown, type Order } from './order.ts'
import { lastTicks, shownRows, withoutLast, withoutRows, type ShownRow } from './table.ts'

/** `remember`: one row at a time · `drive`: a hand drives · `coach`: the net drives until a hand takes over · `copy`: a program drives. */
export const modes = ['remember', 'drive', 'coach', 'copy'] as const
export type Mode = (typeof modes)[number]

const byMode: { readonly [mode in Exclude<Mode, 'remember'>]: Drive['by'] } = {
  drive: 'pad',
  coach: 'coach',
  copy: 'program',
}

const still: Wheels = { left: 0, right: 0 }
const fiveSeconds = 300
const usualRate = 10

/** What a hand shows the network on the screen. */
export class Showing {
  readonly session: LabSession
  readonly #assignment: Assignment
  #mode = $state<Mode>('remember')
  /** What the hand holds: the wheels, and other outputs by their neurons. */
  #wheels = $state.raw<Wheels>(still)
  others = $state.raw<{ readonly [neuron: string]: number }>({})
  #isHeld = $state(false)
  /** There was no room for another row. */
  #isFull = $state(false)
  /** Which rows are looked at, and in which order. */
  order = $state.raw<Order>(asShown)
  /** Rows a second while a hand drives. */
  rate = $state(usualRate)
  /** Only what Bo sees is seen. null: as it is usual for the way of showing. */
  #eyes = $state<boolean | null>(null)

  constructor(assignment: Assignment) {
    this.session = assignment.session
    this.#assignment = assignment
    this.session.listen((event) => this.#heed(event))
  }

  get net() {
    return this.#assignment.net
  }
  get examples(): Examples | null {
    return this.#assignment.examples
  }
  get mode() {
    return this.#mode
  }
  set mode(mode: Mode) {
    this.end()
    this.#mode = mode
    this.#chosen = null
    this.#wheels = still
  }
  get wheels() {
    return this.#wheels
  }
  get isHeld() {
    return this.#isHeld
  }
  get isFull() {
    return this.#isFull
  }
  /** Rows are written while a hand is on, or while the program drives. */
  readonly recording = $derived.by(() => {
    const { phase } = this.session.lab.facts
    return this.session.lab.view.recording !== null && phase === 'running'
  })
  get eyes() {
    return this.#eyes ?? (this.#mode === 'drive' || this.#mode === 'coach')
  }
  set eyes(on: boolean) {
    this.#eyes = on
  }

  readonly #inputs = $derived.by(() => this.net?.inputs.map(({ id }) => id) ?? [])
  readonly #outputs = $derived.by(() => this.net?.outputs.map(({ id }) => id) ?? [])
  readonly rows: readonly ShownRow[] = $derived.by(() =>
    this.examples ? shownRows(this.examples, this.#inputs, this.#outputs) : [],
  )
  readonly onRows = $derived.by(() => this.rows.filter(({ on }) => on))
  readonly asideRows = $derived.by(() => this.rows.filter(({ on }) => !on))
  /** Places of the wheels among the outputs; null: the network has not both. */
  readonly drives = $derived.by(() => this.net && wheelsIn(this.net, this.session.config))
  /** Outputs that are no wheels. */
  readonly otherOutputs = $derived.by(() => {
    const { net, drives } = this
    return net?.outputs.filter((_, at) => at !== drives?.left && at !== drives?.right) ?? []
  })
  readonly choice = $derived.by(() => (this.net ? choiceIn(this.net) : null))

  /** The row that is looked at: its place in the table. */
  #chosen = $state<number | null>(null)
  readonly chosen = $derived.by(() => (this.#chosen === null ? null : (this.rows[this.#chosen] ?? null)))
  choose(at: number | null): void {
    this.#chosen = this.#chosen === at ? null : at
  }

  set(wheels: Wheels): void {
    this.#wheels = wheels
    if (this.#isHeld) this.session.lab.drive(wheels, this.others)
  }

  setOther(neuron: string, value: number): void {
    const all = this.choice === 'one' && value > 0 ? this.otherOutputs.map(({ id }) => [id, -100]) : []
    this.others = { ...this.others, ...(Object.fromEntries(all) as typeof this.others), [neuron]: value }
    if (this.#isHeld) this.session.lab.drive(this.#wheels, this.others)
  }

  remember(): void {
    if (!this.net) return
    this.#isFull = !this.session.examples.remember(this.net.id, this.#wheels, this.others)
    if (!this.#isFull) this.#chosen = this.rows.length - 1
  }

  /** A hand is on the pad: where it drives, Bo goes. */
  hold(wheels: Wheels): void {
    this.#wheels = wheels
    if (this.#mode === 'remember' || this.#mode === 'copy' || !this.net) return
    if (!this.#begin()) return
    this.#isHeld = true
    this.session.effort.touch()
    this.session.lab.drive(wheels, this.others)
  }

  /** It lets go: Bo waits; while it is coached, its network drives on. */
  letGo(): void {
    if (!this.#isHeld) return
    this.#isHeld = false
    this.session.effort.touch()
    this.session.lab.drive(null)
    if (this.#mode === 'drive') {
      this.#wheels = still
      this.session.lab.pause()
    }
  }

  /** The run is on and rows are written. Returns whether it could begin. */
  #begin(): boolean {
    const { session, net } = this
    if (!net || this.#mode === 'remember') return false
    const { phase } = session.lab.facts
    if (phase === 'paused') session.resume()
    else if (phase !== 'running' && session.start() !== null) return false
    if (!session.lab.view.recording) session.examples.record(net.id, byMode[this.#mode], this.rate)
    return session.lab.facts.phase === 'running'
  }

  /** The network or the program drives, and Bo writes down what a hand, or the program, does. */
  begin(): void {
    this.#begin()
  }

  pause(): void {
    this.session.lab.pause()
  }

  /** The drive is over: it is one step to undo. */
  end(): void {
    this.letGo()
    this.session.examples.stop()
  }

  undo(): void {
    if (!this.net || !this.examples) return
    this.end()
    this.#chosen = null
    this.session.examples.replace(this.net.id, withoutLast(this.examples))
  }

  /** Rows of the last five seconds. */
  readonly lastFive = $derived.by(() => (this.examples ? lastTicks(this.examples, fiveSeconds) : []))

  throwLastFive(): void {
    this.change((examples) => withoutRows(examples, this.lastFive))
  }

  change(change: (examples: Examples) => Examples): void {
    if (!this.net) return
    this.session.examples.stop()
    this.session.examples.change(this.net.id, change)
  }

  #heed(event: LabEvent): void {
    if (event.kind === 'changed' && event.change.kind === 'program') this.end()
  }
}
