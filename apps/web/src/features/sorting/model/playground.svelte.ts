import { stepOne, stepPhase, type Distance } from '@botgarten/learning/k-means'
import { mostOfSorting } from '@botgarten/programs/sorting'
import { Steps } from './steps.svelte.ts'
import type { Store } from './store.svelte.ts'
import {
  isSame,
  MOST_POINTS,
  OWN_TABLE,
  placed,
  pointsIn,
  thrown,
  withAxis,
  withDistance,
  withFeature,
  withFlags,
  withName,
  withoutPoints,
  withoutReadings,
  withReadings,
  withRows,
  withTable,
  workOfFile,
  workOfSet,
  workOfTrap,
  type Source,
  type Start,
  type Work,
} from './work.ts'

const beats = [1400, 700, 350] as const

const firstOn: { readonly [source in Source]: (work: Work) => Work } = {
  things: (work) => workOfSet(work, 'vessels'),
  points: (work) => workOfTrap(work, 'heaps'),
  readings: withoutReadings,
}

/** What is sorted, and what a child's hand does to it. Everything that changes it is a step on a line that leads back. */
export class Playground {
  readonly #steps: Steps
  #timer: ReturnType<typeof setInterval> | undefined
  #speed = $state(1)
  #playing = $state(false)
  /** The thing or point that a finger is on. */
  touched = $state<number | null>(null)

  constructor(store: Store) {
    this.#steps = new Steps(store)
  }

  get unread(): boolean {
    return this.#steps.unread
  }

  get work(): Work {
    return this.#steps.work
  }

  get at(): number {
    return this.#steps.at
  }

  get last(): number {
    return this.#steps.last
  }

  get playing(): boolean {
    return this.#playing
  }

  get speed(): number {
    return this.#speed
  }

  nameOf(group: number): string {
    return this.work.names[group] ?? ''
  }

  get done(): boolean {
    return this.work.state?.phase === 'done'
  }

  // ---- what is sorted ----

  /** To the last data set of this source, as it was left. */
  turnTo(source: Source): void {
    this.#turn(source, undefined, firstOn[source])
  }

  takeSet(id: string): void {
    this.#turn('things', id, (work) => workOfSet(work, id))
  }

  takeTrap(name: string): void {
    this.#turn('points', name, (work) => workOfTrap(work, name))
  }

  /** To the points that were drawn by hand. */
  takeOwn(): void {
    this.#turn('points', '', withoutPoints)
  }

  /** To the points of the file that was opened last. */
  takeOwnTable(): void {
    this.#turn('points', OWN_TABLE, (work) => work)
  }

  /** Was a file opened? */
  get hasTable(): boolean {
    return this.work.set === OWN_TABLE || this.#steps.leftOn('points', OWN_TABLE) !== undefined
  }

  takeTable(names: readonly string[], rows: readonly (readonly number[])[]): void {
    this.#leave()
    this.#do(workOfFile(this.work, names, rows))
  }

  #turn(source: Source, set: string | undefined, begin: (work: Work) => Work): void {
    const { work } = this
    if (isSame(work, { source, set: set ?? work.set })) return
    this.#leave()
    this.#do(this.#steps.leftOn(source, set) ?? begin(work))
  }

  #leave(): void {
    this.endCollecting()
    this.pause()
    this.touched = null
    this.#steps.leave()
  }

  /** The points of this data set as they were in the beginning; drawn ones are gone. */
  resetPoints(): void {
    const { work } = this
    this.#begin(work.set === '' ? withoutPoints(work) : workOfTrap(work, work.set))
  }

  clearReadings(): void {
    this.#begin(withoutReadings(this.work))
  }

  #begin(work: Work): void {
    this.pause()
    this.touched = null
    this.#do(work)
  }

  count(feature: string, on: boolean): void {
    this.#do(withFeature(this.work, feature, on))
  }

  addPoint(x: number, y: number): void {
    const { columns, rows } = this.work.table
    if (rows.length >= MOST_POINTS || columns.length !== 2) return
    this.touched = null
    this.#do(withRows(this.work, [...rows, [x, y]]))
  }

  removePoint(point: number): void {
    const rows = this.work.table.rows.filter((_, index) => index !== point)
    this.touched = null
    this.#do(withRows(this.work, rows))
  }

  /**
   * What Bo's sensor reads while it drives, rows of red, green and blue, 0 to 255: it lies on the plane at once, and a whole
   * drive is one step. Flags come when it ends.
   */
  collect(readings: readonly (readonly number[])[]): void {
    if (this.work.source !== 'readings') return
    this.touched = null
    this.pause()
    this.#steps.extend(withReadings(this.work, readings), 'readings')
    this.#keep()
  }

  /** Does what Bo reads still belong to the step that is shown? */
  get collecting(): boolean {
    return this.#steps.isOpenFor('readings')
  }

  endCollecting(): void {
    if (!this.collecting) return
    this.#steps.end()
    this.#steps.replace(withTable(this.work, this.work.table))
    this.#keep()
  }

  // ---- flags ----

  setFlags(flags: number): void {
    this.#change(withFlags(this.work, flags))
  }

  throwFlags(start: Start): void {
    this.endCollecting()
    this.#do(thrown(this.work, start))
  }

  get before(): Work | null {
    return this.#steps.sortedFrom
  }

  /** `live`: the hand still holds it; a whole drag is one step. */
  placeFlag(flag: number, centre: readonly number[], live: boolean): void {
    const { work } = this
    if (!work.state) return
    const isNew = this.#steps.extend(placed(work, work.state.centres.with(flag, centre)), 'flag')
    if (isNew) this.#keep()
    if (!live) this.#steps.end()
  }

  letGo(): void {
    this.#steps.end()
    this.#keep()
  }

  setDistance(distance: Distance): void {
    this.#change(withDistance(this.work, distance))
  }

  setAxis(axis: 0 | 1, column: number): void {
    this.#steps.replace(withAxis(this.work, axis, column))
    this.#keep()
  }

  /** All letters of one name are one step. */
  name(group: number, name: string): void {
    this.#steps.extend(withName(this.work, group, name.slice(0, mostOfSorting.name)), `name ${group}`)
    this.#keep()
  }

  // ---- sorting ----

  /** One point joins, or one flag moves. */
  stepOne(): void {
    const { work } = this
    if (!work.state || this.done) return
    const { state, trace } = stepOne(pointsIn(work.table), work.state)
    this.touched = trace?.kind === 'assign' ? trace.point : null
    this.#do({ ...work, state })
  }

  /** All points join, or all flags move. */
  stepAll(): void {
    const { work } = this
    if (!work.state || this.done) return
    this.#do({ ...work, state: stepPhase(pointsIn(work.table), work.state) })
  }

  /** To the beginning of this sorting: the flags where they were placed. */
  again(): void {
    const { work } = this
    if (work.state) this.#do(placed(work, work.start))
  }

  play(): void {
    if (this.#playing) return this.pause()
    if (this.done) this.again()
    this.#playing = true
    this.stepAll()
    this.#beat()
  }

  pause(): void {
    clearInterval(this.#timer)
    if (!this.#playing) return
    this.#playing = false
    this.#keep()
  }

  /** The page is hidden, or left without a farewell. */
  save(): void {
    this.#steps.flush()
  }

  close(): void {
    this.endCollecting()
    this.pause()
    this.#steps.store.close()
  }

  setSpeed(speed: number): void {
    this.#speed = speed
    if (this.#playing) this.#beat()
  }

  #beat(): void {
    clearInterval(this.#timer)
    this.#timer = setInterval(() => {
      this.stepAll()
      if (this.done || !this.work.state) this.pause()
    }, beats[this.#speed])
  }

  // ---- the way back ----

  goTo(at: number): void {
    this.#leave()
    this.#steps.goTo(at)
    this.#keep()
  }

  /** While Bo drives, what changes belongs to that step. */
  #change(work: Work): void {
    if (!this.collecting) return this.#do(work)
    this.#steps.replace(work)
    this.#keep()
  }

  #do(work: Work): void {
    this.#steps.add(work)
    this.#keep()
  }

  /** Not in the middle of playing: a moment of that is not worth a record. */
  #keep(): void {
    this.#steps.keep(this.#playing)
  }
}
