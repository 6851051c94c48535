import {
  FRONT,
  HALF_WIDTH,
  REAR,
  type Cm,
  type Degrees,
  type SensorKind,
  type SensorPlace,
} from '@botgarten/simulation'

/** A point of the picture, in cm: the robot's front is up, the middle of its axle is 0. */
export interface Spot {
  readonly x: Cm
  readonly y: Cm
}

export const kinds = [
  'ultrasonic',
  'colour',
  'touch',
  'gyro',
  'infrared',
  'sound',
  'compass',
  'position',
  'irseeker',
] as const satisfies readonly SensorKind[]

/** Half a centimetre and five degrees: what a hand can hit. */
const GRID: Cm = 0.5
const NOTCH: Degrees = 5
/** A sensor may be let go of this far beside the body. */
const BESIDE: Cm = 3

/** Does it look somewhere? Others feel what is where they sit. */
export const hasDirection = (kind: SensorKind): boolean => kind === 'ultrasonic' || kind === 'infrared'

/** Where a sensor is drawn. */
export const spotOf = ({ x, y }: SensorPlace): Spot => ({ x: 0 - y, y: 0 - x })

export const isOnRobot = ({ x, y }: Spot): boolean =>
  Math.abs(x) <= HALF_WIDTH + BESIDE && y >= -FRONT - BESIDE && y <= REAR + BESIDE

const onGrid = (value: number, step: number) => Math.round(value / step) * step + 0
const within = (value: number, low: number, high: number) => Math.max(low, Math.min(high, value))

/** The sensor at another place of the body; a bumper sits in front or behind. */
export function movedTo(place: SensorPlace, spot: Spot): SensorPlace {
  if (place.kind === 'touch') return bumper(0 - spot.y)
  const x = within(onGrid(0 - spot.y, GRID), -REAR, FRONT)
  const y = within(onGrid(0 - spot.x, GRID), -HALF_WIDTH, HALF_WIDTH)
  return { ...place, x, y }
}

const bumper = (x: Cm): SensorPlace =>
  x < (FRONT - REAR) / 2
    ? { kind: 'touch', x: -REAR, y: 0, angle: 180 }
    : { kind: 'touch', x: FRONT, y: 0, angle: 0 }

/** Moved by the arrow keys: half a centimetre in the picture. */
export function nudged(place: SensorPlace, right: number, down: number): SensorPlace {
  const { x, y } = spotOf(place)
  const far = place.kind === 'touch' ? FRONT + REAR : GRID
  return movedTo(place, { x: x + right * far, y: y + down * far })
}

/** −180 < angle ≤ 180 */
function half(angle: Degrees): Degrees {
  const turned = angle - 360 * Math.floor(angle / 360)
  return turned > 180 ? turned - 360 : turned
}

/** Turned to the left by so many notches. */
export const turnedBy = (place: SensorPlace, notches: number): SensorPlace => ({
  ...place,
  angle: half(onGrid(place.angle + notches * NOTCH, NOTCH)),
})

/** Turned to look at a point of the picture. */
export function lookingAt(place: SensorPlace, spot: Spot): SensorPlace {
  const from = spotOf(place)
  const angle = (Math.atan2(from.x - spot.x, from.y - spot.y) * 180) / Math.PI
  return { ...place, angle: half(onGrid(angle, NOTCH)) }
}

/** Where the handle that turns it is drawn: in front of it. */
export function handleOf(place: SensorPlace, away: Cm): Spot {
  const { x, y } = spotOf(place)
  const angle = (place.angle * Math.PI) / 180
  return { x: x - away * Math.sin(angle), y: y - away * Math.cos(angle) }
}

const byKey: { readonly [key: string]: (place: SensorPlace) => SensorPlace } = {
  ArrowLeft: (place) => nudged(place, -1, 0),
  ArrowRight: (place) => nudged(place, 1, 0),
  ArrowUp: (place) => nudged(place, 0, -1),
  ArrowDown: (place) => nudged(place, 0, 1),
  ',': (place) => (hasDirection(place.kind) ? turnedBy(place, 1) : place),
  '.': (place) => (hasDirection(place.kind) ? turnedBy(place, -1) : place),
}

/** Where a key puts it; null for a key that means nothing here. */
export const placedByKey = (place: SensorPlace, key: string): SensorPlace | null =>
  Object.hasOwn(byKey, key) ? byKey[key]!(place) : null
