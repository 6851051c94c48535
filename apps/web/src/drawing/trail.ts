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

/** Where a robot has been, dotted. Only what is new is dotted. */
class Trail {
  #paths: Command[] = []
  #last = ''
  #dotsInLast = 0
  #dotting = undotted
  #drawn: { readonly count: number; readonly last: TrailPoint | undefined } = { count: 0, last: undefined }
  #for = ''

  /** @param trail in cm; the same points as before and some more, else it is dotted from its beginning */
  dots(trail: readonly TrailPoint[], floor: Size, scale: number, colour: string): Dots {
    const target = [scale, floor.height, colour].join()
    if (target !== this.#for || !this.#goesOn(trail)) this.#begin(target)
    if (this.#drawn.count === trail.length) return this.#all(colour)
    const fresh = trail.slice(this.#drawn.count).map((point) => onFloor(point, floor, scale))
    const { dots, dotting } = dotsAlong(fresh, gap, this.#dotting)
    this.#dotting = dotting
    this.#drawn = { count: trail.length, last: trail.at(-1) }
    for (const dot of dots) this.#add(dot, colour)
    return this.#all(colour)
  }

  #goesOn(trail: readonly TrailPoint[]): boolean {
    const { count, last } = this.#drawn
    return count <= trail.length && trail[count - 1]?.t === last?.t
  }

  #begin(target: string): void {
    this.#for = target
    this.#paths = []
    this.#last = ''
    this.#dotsInLast = 0
    this.#dotting = undotted
    this.#drawn = { count: 0, last: undefined }
  }

  #add({ x, y }: Point, colour: string): void {
    this.#last += `M${tenth(x)} ${tenth(y)}h0`
    this.#dotsInLast += 1
    if (this.#dotsInLast < dotsInPath) return
    this.#paths.push(dotted(this.#last, colour))
    this.#last = ''
    this.#dotsInLast = 0
  }

  #all(colour: string): Dots {
    return { done: this.#paths, growing: this.#last ? [dotted(this.#last, colour)] : [] }
  }
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
