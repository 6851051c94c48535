import type { RobotConfig, SensorPlace } from '@botgarten/simulation'
import { partsOf } from '#drawing/bo.ts'
import type { Point } from '#drawing/points.ts'

/** A part that is seen on Bo from above. */
export interface BoPart {
  readonly kind: 'ultrasonic' | 'infrared' | 'colour' | 'wheel' | 'lamp' | 'display'
  /** Where it is plugged in: of a sensor, of a wheel's motor; of the others nowhere. */
  readonly port: string | null
  readonly at: Point
}

const seen = ['ultrasonic', 'infrared', 'colour'] as const
type Seen = (typeof seen)[number]
const isSeen = (kind: SensorPlace['kind']): kind is Seen => (seen as readonly string[]).includes(kind)

/** The foot of the display, so that a line from it runs behind the wheel. */
const parts: readonly BoPart[] = [
  { kind: 'lamp', port: null, at: { x: -1, y: 4.3 } },
  { kind: 'display', port: null, at: { x: 2.4, y: 1.4 } },
]

/** What a robot of this configuration has that is seen from above. */
export function boParts(config: RobotConfig): readonly BoPart[] {
  const { sensors, drive, trackWidth } = config
  const drawn = partsOf(config)
  const eyes = Object.entries(sensors).flatMap(([port, { kind }]): BoPart[] => {
    const at = drawn.find(({ part }) => part === `sensor ${port}`)
    return isSeen(kind) && at ? [{ kind, port, at: { x: at.x, y: at.y } }] : []
  })
  const wheels = (['left', 'right'] as const).map((side): BoPart => {
    const x = (side === 'left' ? -1 : 1) * (trackWidth / 2)
    return { kind: 'wheel', port: drive[side], at: { x, y: 0 } }
  })
  return [...eyes, ...wheels, ...parts]
}

/** Where a name stands beside a drawing: at the end of a line from what it names. */
export interface Leader {
  readonly side: 'left' | 'right'
  readonly y: number
}

/**
 * Names as near to what they name as they can be, so far apart that none covers another, in the order of what they name:
 * no two lines of a side cross. What stands in the middle goes where there is less.
 */
export function leaders(spots: readonly Point[], apart: number): readonly Leader[] {
  const sides = sidesOf(spots)
  const all: Leader[] = []
  for (const side of ['left', 'right'] as const) {
    const own = [...spots.keys()].filter((at) => sides[at] === side).sort((a, b) => spots[a]!.y - spots[b]!.y)
    const places = spread(
      own.map((at) => spots[at]!.y),
      apart,
    )
    own.forEach((at, k) => (all[at] = { side, y: places[k]! }))
  }
  return all
}

function sidesOf(spots: readonly Point[]): readonly Leader['side'][] {
  let more = spots.reduce((sum, { x }) => sum + Math.sign(x), 0)
  return spots.map(({ x }) => {
    if (x !== 0) return x < 0 ? 'left' : 'right'
    const side = more > 0 ? 'left' : 'right'
    more += side === 'left' ? -1 : 1
    return side
  })
}

/** Ascending places, moved as little as can be until each is so far from the next. */
function spread(places: readonly number[], apart: number): readonly number[] {
  const groups: { sum: number; count: number }[] = []
  const middle = ({ sum, count }: { sum: number; count: number }) => sum / count
  places.forEach((place, at) => {
    // Counted without the room between them, places that must not meet are places that must not turn round.
    groups.push({ sum: place - at * apart, count: 1 })
    while (groups.length > 1 && middle(groups.at(-2)!) > middle(groups.at(-1)!)) {
      const { sum, count } = groups.pop()!
      const before = groups.pop()!
      groups.push({ sum: before.sum + sum, count: before.count + count })
    }
  })
  return groups
    .flatMap((group) => Array.from({ length: group.count }, () => middle(group)))
    .map((place, at) => place + at * apart)
}
