import type { SensorPlace } from '@botgarten/simulation'
import { lookingAt, movedTo, spotOf, type Spot } from './placing.ts'

/** How a pointer holds a sensor: by its mark, or by the handle that turns it. */
export interface Grip {
  readonly kind: 'move' | 'turn'
  /** From the pointer to the middle of the mark, in cm of the picture; 0 for the handle. */
  readonly dx: number
  readonly dy: number
}

/** The grip of a pointer that goes down at `point`: the mark does not jump under it. */
export function gripAt(kind: Grip['kind'], place: SensorPlace, point: Spot): Grip {
  if (kind === 'turn') return { kind, dx: 0, dy: 0 }
  const { x, y } = spotOf(place)
  return { kind, dx: x - point.x, dy: y - point.y }
}

/** Where the sensor is while the pointer that holds it is at `point`. */
export function placeIn({ kind, dx, dy }: Grip, place: SensorPlace, { x, y }: Spot): SensorPlace {
  const to = { x: x + dx, y: y + dy }
  return kind === 'move' ? movedTo(place, to) : lookingAt(place, to)
}
