import { startAt, stepOne, stepPhase, type Distance, type KState } from '@botgarten/learning/k-means'
import { firstWork, LONGEST_NAME, othersIn, read, written } from './kept.ts'
import { setOf } from '#figures/things/sets.ts'
import { deviceShelf, type Shelf } from './shelf.ts'
import { traps } from './traps.ts'
import {
  FIRST_FLAGS,
  fileTable,
  handTable,
  MOST_POINTS,
  placed,
  pointsIn,
  readingTable,
  thingTable,
  thrown,
  withFlags,
  withReadings,
  withTable,
  type Source,
  type Start,
  type Work,
} from './work.ts'

const LONGEST = 400
const beats = [1400, 700, 350] as const

/** The playground's one state. Everything that changes what is sorted is a step on a line that leads back. */
export class Desk {
  #line = $state.raw<readonly Work[]>([])
  #at = $state(0)
  #timer: ReturnType<typeof setInterval> | undefined
  #speed = $state(1)
  #playing = $state(false)
  /** What was left on the pages that are not shown. */
  #left: { readonly [source in Source]?: Work }
  /** The thing or point that a finger is on. */
  touched = $state<number | null>(null)
  readonly shelf: Shelf
  /** A newer Botgarten has left something here, or it is broken: it stays as it is until something is changed. */
  readonly unread: boolean

  constructor(shelf: Shelf = deviceShelf()) {
    this.shelf = shelf
    const work = read(shelf.kept)
    this.unread = work === null && shelf.kept !== null
    this.#line = [work ?? firstWork()]
    this.#left = Object.fromEntries(othersIn(shelf.kept).map((one) => [one.source, one]))
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

  /** To another page, as it was left. */
  turnTo(source: Source): void {
    if (source === this.work.source) return
    this.#leave()
    const left = this.#left[source]
    if (left) this.#do(left)
    else if (source === 'things') this.takeSet('vessels')
    else if (source === 'points') this.takeTrap('heaps')
    else this.clearReadings()
  }

  #leave(): void {
    this.endCollecting()
    this.pause()
    this.touched = null
    this.#left = { ...this.#left, [this.work.source]: this.work }
  }

  takeSet(id: string): void {
    const counting = setOf(id).features.flatMap((feature, at) => (at < 2 ? [feature.id] : []))
    const work = { ...this.work, source: 'things' as const, set: id, counting, flags: FIRST_FLAGS }
    this.#begin(withTable(work, thingTable(setOf(id), counting)))
  }

  takeTrap(name: string): void {
    const { flags, rows } = traps[name]!
    const work = { ...this.work, source: 'points' as const, set: name, counting: [], flags }
    this.#begin(withTable(work, handTable(rows())))
  }

  /** Columns and rows of a file. */
  takeTable(names: readonly string[], rows: readonly (readonly number[])[]): void {
    const work = { ...this.work, source: 'points' as const, set: '', counting: [], flags: FIRST_FLAGS }
    this.#begin(withTable(work, fileTable(names, rows)))
  }

  count(feature: string, on: boolean): void {
    const { set, counting } = this.work
    const next = on ? [...counting, feature] : counting.filter((one) => one !== feature)
    this.#do(withTable({ ...this.work, counting: next }, thingTable(setOf(set), next)))
  }

  addPoint(x: number, y: number): void {
    const { columns, rows } = this.work.table
    if (rows.length >= MOST_POINTS || columns.length !== 2) return
    this.#rows([...rows, [x, y]])
  }

  removePoint(point: number): void {
    this.#rows(this.work.table.rows.filter((_, index) => index !== point))
  }

  clearPoints(): void {
    this.#begin(withTable({ ...this.work, set: '' }, handTable([])))
  }

  /**
   * What Bo's sensor reads while it drives, rows of red, green and blue, 0 to 255: it lies on the plane at once, and a whole
   * drive is one step. Flags come when it ends.
   */
  collect(readings: readonly (readonly number[])[]): void {
    if (this.work.source !== 'readings') return
    const next = withReadings(this.work, readings)
    this.touched = null
    this.pause()
    this.#change(next)
    this.#collecting = true
    this.#keep()
  }

  /** Does what Bo reads still belong to the step that is shown? */
  get collecting(): boolean {
    return this.#collecting
  }
  #collecting = false

  endCollecting(): void {
    if (!this.#collecting) return
    this.#collecting = false
    this.#replace(withTable(this.work, this.work.table))
    this.#keep()
  }

  clearReadings(): void {
    const work = { ...this.work, source: 'readings' as const, set: '', counting: [], flags: FIRST_FLAGS }
    this.#begin(withTable(work, readingTable([])))
  }

  // The flags stay where they are while points come and go, as long as there are enough.
  #rows(rows: Work['table']['rows']): void {
    const { work } = this
    const table = { ...work.table, rows }
    this.touched = null
    const enough = work.state !== null && rows.length >= work.flags
    if (!enough) this.#do(withTable({ ...work, set: '' }, table))
    else this.#do(placed({ ...work, set: '', table }, work.state.centres))
  }

  // ---- flags ----

  setFlags(flags: number): void {
    this.#change(withFlags(this.work, flags))
    this.#keep()
  }

  throwFlags(start: Start): void {
    this.endCollecting()
    this.#do(thrown(this.work, start))
  }

  /** The step before, where only sorting lies between. */
  before(at: number): Work | null {
    const before = this.#line[at - 1]
    return before?.table === this.#line[at]?.table && !isFresh(this.work.state) ? (before ?? null) : null
  }

  letGo(): void {
    this.#held = false
    this.#keep()
  }

  /** `live`: the hand still holds it; a whole drag is one step. */
  placeFlag(flag: number, centre: readonly number[], live: boolean): void {
    const { work } = this
    if (!work.state) return
    const next = placed(work, work.state.centres.with(flag, centre))
    if (this.#held) this.#replace(next)
    else this.#do(next)
    this.#held = live
  }
  #held = false

  setDistance(distance: Distance): void {
    const { work } = this
    const next = { ...work, distance }
    this.#change(work.state ? placed(next, work.state.centres) : next)
    this.#keep()
  }

  setAxis(axis: 0 | 1, column: number): void {
    const { axes } = this.work
    const other = axes[1 - axis]!
    const swapped = column === other ? axes[axis] : other
    const next = axis === 0 ? ([column, swapped] as const) : ([swapped, column] as const)
    this.#replace({ ...this.work, axes: next })
    this.#keep()
  }

  /** All letters of one name are one step. */
  name(group: number, name: string): void {
    const { work } = this
    const names = Array.from({ length: Math.max(work.names.length, group + 1) }, (_, at) => this.nameOf(at))
    const next = { ...work, names: names.with(group, name.slice(0, LONGEST_NAME)) }
    if (this.#naming === group) this.#replace(next)
    else this.#do(next)
    this.#naming = group
    this.#keep()
  }
  #naming: number | null = null

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
    const first = this.#line.slice(0, this.#at + 1).findLast((one) => isFresh(one.state))
    const centres = first?.state?.centres
    if (!work.state || centres?.length !== work.flags) return
    this.#do({ ...work, state: startAt(pointsIn(work.table), centres, work.distance) })
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
    if (this.#unkept) this.#write()
    this.shelf.flush()
  }

  close(): void {
    this.endCollecting()
    this.pause()
    this.shelf.close()
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
    this.#naming = null
    this.#at = Math.max(0, Math.min(this.last, at))
    this.#keep()
  }

  #begin(work: Work): void {
    this.pause()
    this.touched = null
    this.#do({ ...work, names: [] })
  }

  /** While Bo drives, what changes belongs to that step. */
  #change(work: Work): void {
    if (this.#collecting) this.#replace(work)
    else this.#do(work)
  }

  #do(work: Work): void {
    this.#collecting = false
    this.#held = false
    this.#naming = null
    this.#line = [...this.#line.slice(Math.max(0, this.#at + 2 - LONGEST), this.#at + 1), work]
    this.#at = this.#line.length - 1
    this.#keep()
  }

  #replace(work: Work): void {
    this.#line = this.#line.with(this.#at, work).slice(0, this.#at + 1)
  }

  /** Not in the middle of playing: a moment of that is not worth a record. */
  #keep(): void {
    this.#unkept = true
    if (!this.#playing) this.#write()
  }

  #write(): void {
    this.shelf.keep(() => written(this.work, Object.values(this.#left)))
    this.#unkept = false
  }
  #unkept = false
}

const isFresh = (state: KState | null) =>
  state !== null && state.phase === 'assign' && state.round === 0 && state.next === 0
