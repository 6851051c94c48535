import type { TrailPoint } from '@botgarten/lab'
import { onFloor } from './camera.ts'
import type { Command } from './commands.ts'
import { tenth, type Point, type Size } from './points.ts'

/** Where the dotting of a trail has come to: what is left until the next dot, and the last point. */
export interface Dotting {
  readonly last: Point | null
  readonly left: number
}

const undotted: Dotting = { last: null, left: 0 }

/**
 * Dots every `gap` along a line that grows: gives the new dots for the new points, and where to go on.
 * Dotting a line in pieces gives the same dots as dotting it at once.
 */
export function dotsAlong(
  points: readonly Point[],
  gap: number,
  from: Dotting = undotted,
): { readonly dots: readonly Point[]; readonly dotting: Dotting } {
  const dots: Point[] = []
  let { last, left } = from
  for (const point of points) {
    if (last) left = dotSegment(last, point, gap, left, dots)
    last = point
  }
  return { dots, dotting: { last, left } }
}

function dotSegment(a: Point, b: Point, gap: number, left: number, dots: Point[]): number {
  const length = Math.hypot(b.x - a.x, b.y - a.y)
  let at = left
  for (; at < length; at += gap) {
    const share = at / length
    dots.push({ x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share })
  }
  return at - length
}

const gap = 11
/** In one path: what has been dotted is not read again. */
const dotsInPath = 40

/** Dots in paths: those that stay the same, and those that still grow. */
export interface Dots {
  /** The same object for as long as nothing is added or taken away. */
  readonly done: readonly Command[]
  readonly growing: readonly Command[]
}

/** How far a trail has been dotted. */
interface Dotted {
  /** Points that are dotted, and the last of them. */
  readonly count: number
  readonly last: TrailPoint | undefined
  readonly dotting: Dotting
  /** Full paths, and the one that grows with its dots. */
  readonly paths: number
  readonly growing: string
  readonly dots: number
}

const nothing: Dotted = { count: 0, last: undefined, dotting: undotted, paths: 0, growing: '', dots: 0 }

/** Where a robot has been, dotted. Only what is new is dotted, and after a way back only the path it ends in. */
class Trail {
  #paths: Command[] = []
  #now = nothing
  /** From one each for every full path it can go on: time goes back, too. */
  #past: Dotted[] = []
  #for = ''

  /** @param trail in cm; the same points as before and some more or less, else it is dotted from its beginning */
  dots(trail: readonly TrailPoint[], floor: Size, scale: number, colour: string): Dots {
    const target = [scale, floor.height, colour].join()
    if (target !== this.#for) this.#past = []
    this.#for = target
    if (this.#past.length === 0 || !isIn(trail, this.#now)) this.#goBack(trail)
    for (let at = this.#now.count; at < trail.length; at += 1)
      this.#add(trail[at]!, onFloor(trail[at]!, floor, scale), colour)
    const { growing } = this.#now
    return { done: this.#paths, growing: growing ? [dotted(growing, colour)] : [] }
  }

  /** To where this trail and the last one were the same for sure. */
  #goBack(trail: readonly TrailPoint[]): void {
    const known = this.#past.findLastIndex((one) => isIn(trail, one))
    this.#past = known < 0 ? [nothing] : this.#past.slice(0, known + 1)
    this.#now = this.#past.at(-1)!
    this.#paths = this.#paths.slice(0, this.#now.paths)
  }

  #add(last: TrailPoint, at: Point, colour: string): void {
    const { dots, dotting } = dotsAlong([at], gap, this.#now.dotting)
    const before = this.#now.paths
    this.#now = { ...this.#now, count: this.#now.count + 1, last, dotting }
    for (const dot of dots) this.#dot(dot, colour)
    if (this.#now.paths > before) this.#past.push(this.#now)
  }

  #dot({ x, y }: Point, colour: string): void {
    const growing = `${this.#now.growing}M${tenth(x)} ${tenth(y)}h0`
    const dots = this.#now.dots + 1
    if (dots === dotsInPath) this.#paths.push(dotted(growing, colour))
    this.#now =
      dots === dotsInPath
        ? { ...this.#now, paths: this.#paths.length, growing: '', dots: 0 }
        : { ...this.#now, growing, dots }
  }
}

/** Another future has the same times, and other places. */
function isIn(trail: readonly TrailPoint[], { count, last }: Dotted): boolean {
  const point = trail[count - 1]
  return count <= trail.length && point?.t === last?.t && point?.x === last?.x && point?.y === last?.y
}

const dotted = (d: string, stroke: string): Command => ({ kind: 'path', d, stroke, lineWidth: 4 })

/** The trails of all robots, each in its colour. */
export class Trails {
  readonly #trails = new Map<string, Trail>()
  /** In the order in which they have come: what is painted already stays in front. */
  #done: readonly Command[] = []

  dots(
    robots: readonly { readonly id: string; readonly trail: readonly TrailPoint[] }[],
    floor: Size,
    scale: number,
    colours: readonly string[],
  ): Dots {
    const all = robots.map(({ id, trail }, index) => {
      const own = this.#trails.get(id) ?? new Trail()
      this.#trails.set(id, own)
      return own.dots(trail, floor, scale, colours[index] ?? colours[0]!)
    })
    this.#done = ordered(
      this.#done,
      all.flatMap(({ done }) => done),
    )
    return { done: this.#done, growing: all.flatMap(({ growing }) => growing) }
  }
}

/** Those of now, as they stood before, new ones behind; the same list when nothing is new and nothing is gone. */
function ordered(before: readonly Command[], now: readonly Command[]): readonly Command[] {
  const kept = new Set(before)
  const fresh = now.filter((one) => !kept.has(one))
  const gone = before.length + fresh.length > now.length
  if (fresh.length === 0 && !gone) return before
  const left = new Set(now)
  return [...(gone ? before.filter((one) => left.has(one)) : before), ...fresh]
}
