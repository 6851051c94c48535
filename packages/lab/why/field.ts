import { evaluate } from '@botgarten/programs'
import type { Pose } from '@botgarten/simulation'
import { runFrom, type Standpoint } from './standpoint.ts'

/** Poses between two pauses. */
const SLICE = 8
/** A robot that comes to stand farther from where it was put (cm) has no room there. */
const MOVED = 0.1

/**
 * Poses in a grid over the whole floor, about `count` of them, in rows from below, all with one heading.
 * @param size cm, as the world's
 */
export function gridOf(
  size: { readonly width: number; readonly height: number },
  count: number,
  heading: number,
): { readonly poses: readonly Pose[]; readonly spacing: number } {
  const spacing = Math.sqrt((size.width * size.height) / count)
  const columns = Math.max(1, Math.round(size.width / spacing))
  const rows = Math.max(1, Math.round(size.height / spacing))
  const poses = Array.from({ length: columns * rows }, (_, index) => ({
    x: (((index % columns) + 0.5) * size.width) / columns,
    y: ((Math.floor(index / columns) + 0.5) * size.height) / rows,
    heading,
  }))
  return { poses, spacing }
}

/**
 * What a network's inputs would be with the robot put at each pose, read by the simulation's own sensors; null where there is
 * no room for it. Readings are free of noise. Weights play no part: as long as world and robot stay, they hold for any.
 * Pauses every 8 poses.
 */
export function* readingsAt(
  from: Standpoint,
  robot: string,
  inputs: readonly string[],
  poses: readonly Pose[],
): Generator<undefined, readonly (readonly number[] | null)[]> {
  const run = runFrom({ ...from, going: false, document: withoutNoise(from.document) })
  const one = run.robots.find(({ id }) => id === robot)
  const all: (readonly number[] | null)[] = []
  for (const [index, pose] of poses.entries()) {
    const came = run.simulation.place(robot, pose)
    const moved = Math.abs(came.x - pose.x) + Math.abs(came.y - pose.y)
    all.push(one && moved < MOVED ? inputs.map((id) => Number(evaluate(one.index, id, one.context))) : null)
    if (index % SLICE === SLICE - 1) yield
  }
  return all
}

const withoutNoise = (document: Standpoint['document']) => {
  const robots = document.world.robots.map((one) => ({ ...one, config: { ...one.config, noise: 0 } }))
  return { ...document, world: { ...document.world, robots } }
}
