import { isLearned, ticksOf } from '@botgarten/lab/trying'
import { limits, problemOf, type Minute, type Place, type Problem } from '@botgarten/learning/q-senses'
import { tryingIn, type TryOutline } from '@botgarten/programs'
import type { LabSession } from '#lab/session.svelte.ts'
import { inWorker, type Ears } from './in-worker.ts'
import type { Asked, Report } from './sleep.ts'

/** Changes fields of a block, as one step to undo. */
export type SetFields = (block: string, fields: { readonly [name: string]: string }) => void

/** How a night has ended: `already`: there was nothing to do · `changed`: under its feet · `died`: its worker is gone. */
export type Ending = 'learned' | 'stopped' | 'already' | 'changed' | 'died' | Problem

/** What a child sees of a night. */
interface Shown {
  readonly total: number
  readonly curve: readonly Minute[]
  readonly stuck: number
}
const nothing: Shown = { total: 0, curve: [], stuck: 0 }

const isSame = (a: readonly Minute[], b: readonly Minute[]) =>
  a.length === b.length && a.every(({ pay, bumps }, at) => pay === b[at]!.pay && bumps === b[at]!.bumps)

/** The chosen robot learns as fast as it can while everything stands still; what it has learned is put into the lab. */
export class Night {
  readonly #session: LabSession
  readonly #setFields: SetFields
  readonly #begin: (asked: Asked, ears: Ears) => () => void
  #wake: (() => void) | null = null
  #deaf: () => unknown = () => {}
  #shown = $state.raw<Shown>(nothing)
  /** What the bill of the first robot will say of this night: when it began, in ms, and its bumps. */
  #cost: { readonly began: number; bumps: number } | null = null
  /** How the last one has ended; null: none has, or one is going on. */
  ending = $state<Ending | null>(null)
  /** Ticks of the night that goes on; 0: the robot is awake. */
  ticks = $state(0)

  constructor(session: LabSession, setFields: SetFields, begin = inWorker) {
    this.#session = session
    this.#setFields = setFields
    this.#begin = begin
  }

  /** Places of the card. */
  get places(): readonly Place[] {
    return this.#session.opened.card?.card.starts ?? []
  }
  /** Do tries begin at any of them? */
  get fromAll(): boolean {
    return this.outline?.trial.starts !== undefined
  }
  set fromAll(on: boolean) {
    const { outline, places } = this
    const text = places.slice(0, limits.starts).map(({ x, y }) => `${x} ${y}`)
    if (outline) this.#setFields(outline.id, { STARTS: on ? text.join(', ') : '' })
  }

  get isAsleep(): boolean {
    return this.ticks > 0
  }
  /** Of the night that goes on, or of the last one. */
  get shown(): Shown {
    return this.#shown
  }
  /** What the chosen robot is to learn. */
  get outline(): TryOutline | null {
    return tryingIn(this.#session.program)
  }

  /** Minutes that were tried in the lab, or before, are shown like those of a night. */
  note(curve: readonly Minute[]): void {
    if (!this.isAsleep && !isSame(curve, this.#shown.curve)) this.#shown = { ...nothing, curve }
  }

  begin(): void {
    const { outline } = this
    if (!outline || this.isAsleep) return
    this.ending = this.#reasonNot(outline)
    if (this.ending) return
    const { lab, robot } = this.#session
    lab.reset()
    this.#shown = nothing
    this.#watch(robot.id)
    this.ticks = ticksOf(outline.minutes)
    const { world } = lab.document
    this.#cost = robot === world.robots[0] ? { began: performance.now(), bumps: 0 } : null
    const asked = { world, floor: lab.floor, trial: outline.trial, ticks: this.ticks }
    const ears = { hear: (report: Report) => this.#hear(outline.id, report), fail: () => this.end('died') }
    const wake = this.#begin({ ...asked, robot: world.robots.indexOf(robot) }, ears)
    // It may be over already.
    if (this.isAsleep) this.#wake = wake
  }

  #reasonNot({ id, trial, minutes }: TryOutline): Ending | null {
    const table = this.#session.lab.document.tables?.[id]
    return problemOf(trial) ?? (isLearned(table, trial, minutes) ? 'already' : null)
  }

  /** What it learns would be of another world, or of other blocks, once a hand has changed them. */
  #watch(id: string): void {
    const { lab } = this.#session
    const decides = () => {
      const { world, programs } = lab.document
      const own = world.robots.find((robot) => robot.id === id)
      return JSON.stringify([world, own && programs[own.program] && tryingIn(programs[own.program]!)])
    }
    const before = decides()
    this.#deaf = this.#session.listen(({ kind }) => {
      if (kind === 'changed' && decides() !== before) this.end('changed')
    })
  }

  #hear(id: string, { table, bumps, ...shown }: Report): void {
    if (!this.isAsleep) return
    this.#shown = shown
    if (this.#cost) this.#cost.bumps = bumps
    if (!table) return
    this.end('learned')
    this.#session.lab.reset()
    this.#session.apply({ kind: 'table', id, after: table })
  }

  /** Wakes the robot up; what it has learned so far is forgotten. */
  end(ending: Ending = 'stopped'): void {
    if (!this.isAsleep) return
    this.#wake?.()
    this.#wake = null
    this.#deaf()
    this.ticks = 0
    this.ending = ending
    this.#count()
  }

  /** What was tried has cost its time, whatever came of it. */
  #count(): void {
    const cost = this.#cost
    this.#cost = null
    if (cost) this.#session.effort.computed((performance.now() - cost.began) / 1000, cost.bumps)
  }
}
