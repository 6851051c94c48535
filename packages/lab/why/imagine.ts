import type { Pose } from '@botgarten/simulation'
import type { Brains } from '../robots/brains.ts'
import { runFrom, type Standpoint } from './standpoint.ts'

/** How a robot would go on. */
export interface Imagined {
  /** One a tick, the first is where it stands. */
  readonly poses: readonly Pose[]
  /** Tick, counted from there, at which it first touches something; null where it does not. */
  readonly touchedAt: number | null
}

/** Ticks between two pauses. */
const SLICE = 20

/**
 * Drives on from a moment with other brains, headless and with nobody's hand on it: the same moment, brains and ticks give the same drive.
 * With the brains of the moment it is the drive that comes, as long as no hand interferes. Pauses every 20 ticks.
 * @param robot id; an unknown one stands nowhere
 */
export function* imagine(
  from: Standpoint,
  robot: string,
  brains: Brains,
  ticks: number,
): Generator<undefined, Imagined> {
  const run = runFrom(from, brains)
  const index = run.robots.findIndex(({ id }) => id === robot)
  const pose = run.poseOf(robot)
  const poses: Pose[] = pose ? [pose] : []
  let touchedAt: number | null = null
  for (let tick = 1; pose && tick <= ticks && !run.isOver; tick++) {
    run.advance()
    poses.push(run.poseOf(robot)!)
    if (run.simulation.state.robots[index]!.touching.length > 0) touchedAt ??= tick
    if (tick % SLICE === 0) yield
  }
  return { poses, touchedAt }
}
