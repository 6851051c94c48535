import type { RobotConfig, SensorPlace } from '@botgarten/simulation'
import { clamp, type Point } from './points.ts'

/** Where `BoTop.svelte` draws a sensor, in cm, Bo's front up: one that is said to sit on the edge stays on the head. */
const onHead = ({ x, y }: SensorPlace): Point => ({
  x: clamp(0 - y, -4.2, 4.2),
  y: clamp(0 - x, -6.55, 5.2),
})

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

/** The colour sensor is drawn in the middle of the head, whatever its place. */
const floorEye: Point = { x: 0, y: -5 }
/** The foot of the display, so that a line from it runs behind the wheel. */
const parts: readonly BoPart[] = [
  { kind: 'lamp', port: null, at: { x: -1, y: 4.3 } },
  { kind: 'display', port: null, at: { x: 2.4, y: 1.4 } },
]

/** What a robot of this configuration has that is seen from above. */
export function boParts({ sensors, drive, trackWidth }: RobotConfig): readonly BoPart[] {
  const eyes = Object.entries(sensors).flatMap(([port, place]): BoPart[] => {
    const { kind } = place
    if (!isSeen(kind)) return []
    return [{ kind, port, at: kind === 'colour' ? floorEye : onHead(place) }]
  })
  const wheels = (['left', 'right'] as const).map((side): BoPart => {
    const x = (side === 'left' ? -1 : 1) * (trackWidth / 2)
    return { kind: 'wheel', port: drive[side], at: { x, y: 0 } }
  })
  return [...eyes, ...wheels, ...parts]
}
