import { distancesOf } from '@botgarten/learning/k-means'
import type { Playground } from './playground.svelte.ts'
import { apart, fieldIn, spotOf, under, type Room, type Spot } from './geometry.ts'
import { centreOn, flagsOn, isOnTrays, spotsOn, traysIn } from './trays.ts'
import { pointsIn } from './work.ts'

/** What a tap on the plane does to points. */
export type Tool = 'look' | 'add' | 'remove'

/** Points as dots. */
export interface Dots {
  readonly spots: readonly Spot[]
  readonly labels: readonly number[]
  /** Radius of a dot; 0: things are drawn by others. */
  readonly dot: number
  /** By point, the colour a dot is filled with as red, green and blue; its group's where nothing is said. */
  readonly fills: readonly (readonly number[])[] | null
}

/** What lies under flags and things: areas of the groups, threads to the flags, dots. */
export interface Drawing extends Dots {
  readonly flags: readonly Spot[]
  readonly threads: boolean
}

/** Between the middles of two things in px: each has 44 for a finger. */
const leastApart = 47

const colourOf = (row: readonly number[]) => row.map((value) => (value / 10) * 255)

/** The playground as it lies on the screen: where everything is, and what a finger or a key does to it. */
export class PlaneView {
  readonly playground: Playground
  readonly #tool: () => Tool
  #held = $state<number | null>(null)
  room: Room = $state.raw({ width: 0, height: 0 })
  /** Where the pen is, for keys. */
  cursor = $state.raw({ x: 5, y: 5 })

  constructor(playground: Playground, tool: () => Tool) {
    this.playground = playground
    this.#tool = tool
  }

  // What a step of sorting leaves as it is stays the same object, so that nothing is placed again for it.
  readonly #table = $derived.by(() => this.playground.work.table)
  readonly #axes = $derived.by(() => this.playground.work.axes)
  readonly #source = $derived.by(() => this.playground.work.source)
  readonly #centres = $derived.by(() => this.playground.work.state?.centres ?? [])
  readonly #labels = $derived.by(() => this.playground.work.state?.labels ?? [])
  readonly #fills = $derived.by(() => (this.#source === 'readings' ? this.#table.rows.map(colourOf) : null))
  readonly field = $derived.by(() => fieldIn(this.room))
  /** Where one feature of words is all that counts; null: there are axes. */
  readonly trays = $derived.by(() =>
    isOnTrays(this.playground.work) ? traysIn(this.field, this.#table.columns.length) : null,
  )
  readonly spots = $derived.by(() => {
    if (this.trays) return spotsOn(this.trays, this.#table.rows, leastApart)
    const places = this.#table.rows.map((row) => spotOf(this.field, row, this.#axes))
    return this.isThings
      ? apart(places, Math.min(54, Math.max(leastApart, this.room.width / 12)), this.field)
      : places
  })
  readonly flags = $derived.by(() => this.#flagsOf(this.#centres))
  /** From what is touched to every flag. */
  readonly distances = $derived.by(() => {
    const { touched, work } = this.playground
    if (touched === null || !work.state || touched >= work.table.rows.length) return null
    return distancesOf(pointsIn(work.table), touched, work.state.centres, work.distance)
  })
  /** A flag that moves leaves them as they are. */
  readonly dots: Dots = $derived.by(() => {
    const { spots } = this
    const dot = this.isThings ? 0 : spots.length > 400 ? 4 : spots.length > 120 ? 6 : 8
    return { spots, dot, fills: this.#fills, labels: this.#labels }
  })
  readonly drawing: Drawing = $derived.by(() => {
    const { dots, flags } = this
    return { ...dots, flags, threads: dots.spots.length <= 120 }
  })

  get isThings(): boolean {
    return this.#source === 'things'
  }

  /** The flag that a hand holds. */
  get held(): number | null {
    return this.#held
  }

  get tool(): Tool {
    return this.#tool()
  }

  /** A finger on the plane. */
  tap(x: number, y: number): void {
    const { playground, field, tool } = this
    const near = under(this.spots, x, y, 30)
    if (tool === 'add') playground.addPoint(field.valueX(x), field.valueY(y))
    else if (tool === 'remove' && near !== null) playground.removePoint(near)
    else if (tool === 'look') playground.touched = near
  }

  /** The pen where it is. */
  usePen(): void {
    this.tap(this.field.x(this.cursor.x), this.field.y(this.cursor.y))
  }

  movePen(right: number, up: number): void {
    const held = (value: number) => Math.max(0, Math.min(10, value))
    this.cursor = { x: held(this.cursor.x + right), y: held(this.cursor.y + up) }
  }

  /** To the next point, or the one before. */
  walk(by: 1 | -1): void {
    const { playground } = this
    const count = this.spots.length
    if (count === 0) return
    playground.touched =
      playground.touched === null ? (by > 0 ? 0 : count - 1) : (playground.touched + by + count) % count
  }

  // ---- flags ----

  /** Where flags stood before they moved; a hand that holds one sees none of it. */
  readonly old = $derived.by(() => {
    const { before } = this.playground
    if (this.held !== null || before?.state?.centres.length !== this.flags.length) return []
    const from = this.#flagsOf(before.state.centres)
    return before.state.centres
      .map((_, flag) => ({ flag, from: from[flag]!, to: this.flags[flag]! }))
      .filter(({ from, to }) => Math.hypot(to.x - from.x, to.y - from.y) > 14)
  })

  grab(flag: number): void {
    this.playground.pause()
    this.#held = flag
  }

  /** A hand that holds a flag has moved. */
  drag(x: number, y: number): void {
    if (this.#held !== null) this.#put(this.#held, x, y, true)
  }

  drop(): void {
    if (this.#held === null) return
    this.#held = null
    this.playground.letGo()
  }

  /** By keys, in px. */
  moveFlag(flag: number, right: number, down: number): void {
    this.playground.pause()
    const { x, y } = this.flags[flag]!
    this.#put(flag, x + right, y + down, false)
  }

  #flagsOf(centres: readonly (readonly number[])[]): readonly Spot[] {
    if (this.trays) return flagsOn(this.trays, centres)
    return centres.map((centre) => spotOf(this.field, centre, this.#axes))
  }

  #put(flag: number, x: number, y: number, live: boolean): void {
    const { trays } = this
    if (trays) {
      const { scale } = this.#table.columns[0]!
      return this.playground.placeFlag(flag, centreOn(trays, x, scale), live)
    }
    const [right, up] = this.#axes
    const centre = this.#centres[flag]!.map((value, column) =>
      column === right ? this.field.valueX(x) : column === up ? this.field.valueY(y) : value,
    )
    this.playground.placeFlag(flag, centre, live)
  }
}
