import type { Ground } from '../geometry/near.ts'
import { bringUpToDate, type Outlines } from '../geometry/outlines.ts'
import { rayToFloorEdge, rayToPart, type Beam } from '../geometry/rays.ts'
import type { Cm, Ray, SensorPlace } from '../types.ts'

/** Rays of a distance sensor, as angles from its axis. */
export const CONE = [0, Math.PI / 16, -Math.PI / 16, Math.PI / 8, -Math.PI / 8] as const
const FARTHEST: Cm = 255
/** cos and sin of the cone's half angle, pi/8. */
const HALF_COS = 0.9238795325112867
const HALF_SIN = 0.3826834323650898

const beam: Beam = { x: 0, y: 0, dx: 1, dy: 0 }
/** Bodies that a sensor may see: the first `seen` of them. */
const sight: number[] = []

/** The nearest thing, edge or robot in a sensor's cone, 0..255 cm from its place; its own robot is not seen. */
export function distanceOf(ground: Ground, robot: number, place: SensorPlace, rays: Float64Array): Cm {
  aim(ground.outlines, robot, place)
  turn(ground.outlines, robot, rays, 0)
  const seen = lookAround(ground.outlines, robot)
  let nearest = FARTHEST
  for (let ray = 0; ray < rays.length; ray += 2) {
    turn(ground.outlines, robot, rays, ray)
    nearest = castRay(ground, seen, nearest)
  }
  return nearest
}

/** All rays, each to the first thing it hits. */
export function castCone(
  ground: Ground,
  robot: number,
  place: SensorPlace,
  rays: Float64Array,
  farthest: Cm = FARTHEST,
): Ray[] {
  aim(ground.outlines, robot, place)
  turn(ground.outlines, robot, rays, 0)
  const seen = lookAround(ground.outlines, robot)
  return CONE.map((_, ray): Ray => {
    turn(ground.outlines, robot, rays, ray * 2)
    const distance = castRay(ground, seen, farthest)
    const { x, y, dx, dy } = beam
    return { fromX: x, fromY: y, toX: x + dx * distance, toY: y + dy * distance, distance }
  })
}

/** Puts the beam's start where the sensor is. */
function aim(outlines: Outlines, robot: number, place: SensorPlace): void {
  const c = outlines.cos[robot]!
  const s = outlines.sin[robot]!
  beam.x = outlines.x[robot]! + c * place.x - s * place.y
  beam.y = outlines.y[robot]! + s * place.x + c * place.y
}

function turn(outlines: Outlines, robot: number, rays: Float64Array, ray: number): void {
  const c = outlines.cos[robot]!
  const s = outlines.sin[robot]!
  beam.dx = c * rays[ray]! - s * rays[ray + 1]!
  beam.dy = s * rays[ray]! + c * rays[ray + 1]!
}

/** Gathers the bodies whose circle reaches into the cone round the beam; returns how many. */
function lookAround(outlines: Outlines, robot: number): number {
  let seen = 0
  for (let body = 0; body < outlines.bodies; body++) {
    if (body === robot) continue
    const dx = outlines.x[body]! - beam.x
    const dy = outlines.y[body]! - beam.y
    const ahead = dx * beam.dx + dy * beam.dy
    const aside = Math.abs(dx * beam.dy - dy * beam.dx)
    // The rays' starting skin (geometry/rays.ts) reaches 1 cm back.
    const reach = outlines.reach[body]! + 1
    if (ahead < -reach || ahead > FARTHEST + reach || aside * HALF_COS - ahead * HALF_SIN > reach) continue
    bringUpToDate(outlines, body)
    sight[seen++] = body
  }
  return seen
}

function castRay(ground: Ground, seen: number, limit: Cm): Cm {
  const { outlines, width, height } = ground
  let nearest = Math.min(limit, rayToFloorEdge(beam, width, height))
  for (let index = 0; index < seen; index++) {
    const body = sight[index]!
    for (let part = outlines.firstPart[body]!; part < outlines.firstPart[body + 1]!; part++)
      nearest = rayToPart(outlines, part, beam, nearest)
  }
  return nearest
}
