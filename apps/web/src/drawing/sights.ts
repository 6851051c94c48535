import type { RobotView } from '@botgarten/lab'
import type { RobotConfig, SensorPort } from '@botgarten/simulation'
import { onFloor } from './camera.ts'
import type { Point, Size } from './points.ts'
import { conePolygon, nearestBeam, readingOf, type Beam } from './rays.ts'

/** What one distance sensor sees, in px of the floor's box: its cone, and the ray to the nearest thing. */
export interface Sight {
  readonly port: string
  readonly infrared: boolean
  readonly hit: boolean
  /** What it reads: ultrasonic cm, infrared 0 to 100. */
  readonly reading: number
  readonly cone: readonly Point[]
  readonly near: Beam
}

export function sightsOf(
  robot: RobotView,
  { sensors }: RobotConfig,
  floor: Size,
  scale: number,
): readonly Sight[] {
  return Object.entries(robot.rays).flatMap(([port, rays]) => {
    const beams = rays.map((ray): Beam => ({
      from: onFloor({ x: ray.fromX, y: ray.fromY }, floor, scale),
      to: onFloor({ x: ray.toX, y: ray.toY }, floor, scale),
      distance: ray.distance,
    }))
    const near = nearestBeam(beams)
    const infrared = sensors[port as SensorPort]?.kind === 'infrared'
    return near ? [{ port, infrared, ...readingOf(infrared, near), near, cone: conePolygon(beams) }] : []
  })
}
