import type { RobotView } from '@botgarten/lab'
import { onFloor } from '../drawing/camera.ts'
import type { Point, Size } from '../drawing/points.ts'
import { conePolygon, nearestBeam, type Beam } from '../drawing/rays.ts'

/** What one distance sensor sees, in px of the floor's box: its cone, and the ray to the nearest thing. */
export interface Sight {
  readonly port: string
  readonly cone: readonly Point[]
  readonly near: Beam
}

export function sightsOf(robot: RobotView, floor: Size, scale: number): readonly Sight[] {
  return Object.entries(robot.rays).flatMap(([port, rays]) => {
    const beams = rays.map((ray): Beam => ({
      from: onFloor({ x: ray.fromX, y: ray.fromY }, floor, scale),
      to: onFloor({ x: ray.toX, y: ray.toY }, floor, scale),
      distance: ray.distance,
    }))
    const near = nearestBeam(beams)
    return near ? [{ port, near, cone: conePolygon(beams) }] : []
  })
}
