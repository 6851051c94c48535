import { between, distance, type Point } from '#drawing/points.ts'

/** What two fingers, or one, have done to the floor since the last move: px, and how much nearer it came at a point. */
export interface Gesture {
  readonly right: number
  readonly down: number
  readonly factor: number
  readonly at: Point
}

interface Finger {
  readonly id: number
  readonly at: Point
}

/** Fingers on the floor: one pushes it, two push and stretch it. A third finger does nothing. */
export class Gestures {
  #fingers: readonly Finger[] = []

  down(id: number, at: Point): void {
    if (this.#fingers.length < 2) this.#fingers = [...this.#fingers, { id, at }]
  }

  up(id: number): void {
    this.#fingers = this.#fingers.filter((finger) => finger.id !== id)
  }

  /** null for a finger that is not on the floor. */
  move(id: number, at: Point): Gesture | null {
    const before = this.#fingers
    if (!before.some((finger) => finger.id === id)) return null
    this.#fingers = before.map((finger) => (finger.id === id ? { id, at } : finger))
    const [from, to] = [spanOf(before), spanOf(this.#fingers)]
    return {
      right: to.middle.x - from.middle.x,
      down: to.middle.y - from.middle.y,
      // Fingers that all but touch tell nothing.
      factor: Math.min(from.length, to.length) < 10 ? 1 : to.length / from.length,
      at: to.middle,
    }
  }
}

function spanOf([one, other]: readonly Finger[]): { readonly middle: Point; readonly length: number } {
  if (!one || !other) return { middle: one?.at ?? { x: 0, y: 0 }, length: 0 }
  return { middle: between(one.at, other.at, 0.5), length: distance(one.at, other.at) }
}
