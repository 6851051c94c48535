import { bestAction, payFor, stateOf, type Facts, type TableBrain } from '@botgarten/learning/q-senses'
import { stream } from '@botgarten/numbers'
import {
  createSimulation,
  TICKS_PER_SECOND,
  type Floor,
  type Pose,
  type Simulation,
  type World,
} from '@botgarten/simulation'
import { drive, readingsOf, touchesIn } from './body.ts'
import { beginDoings, behaviourOf, noteTick, type Behaviour } from './doings.ts'

/** One drive, to be watched. */
export interface Watched {
  /** Where it starts, and every 3rd tick after that. */
  readonly poses: readonly Pose[]
  /** Coins of each move, by the table's pay. */
  readonly coins: readonly number[]
  /** Poses that a move takes. */
  readonly posesAMove: number
}
const ticksAPose = 3

/**
 * Drives by the table alone for so many seconds from where each of these worlds has its robot; of equal actions one by
 * chance. It is the robot's own world: noise of seed 1.
 */
export function behave(
  table: TableBrain,
  worlds: readonly World[],
  floor: Floor,
  seconds: number,
): { readonly behaviour: Behaviour; readonly watched: readonly Watched[] } {
  const drives = worlds.map((world) => driveOf(table, createSimulation(world, floor, 1), seconds))
  const ended = drives.filter((one) => one.ended).length
  return {
    behaviour: behaviourOf(
      drives.map(({ doings }) => doings),
      seconds,
      ended,
    ),
    watched: drives.map(({ watched }) => watched),
  }
}

function driveOf(table: TableBrain, simulation: Simulation, seconds: number) {
  const ties = stream(1, `act/${simulation.world.robots[0]!.id}`)
  const doings = beginDoings(simulation)
  const poses: Pose[] = [poseIn(simulation)]
  const coins: number[] = []
  let ended = false
  while (doings.ticks < seconds * TICKS_PER_SECOND && !ended) {
    const state = stateOf(table, readingsOf(simulation, 0, table), touchesIn(simulation, 0))
    drive(simulation, 0, table.actions[bestAction(table.q, state, table.actions.length, ties)]!)
    let facts: Facts | null = null
    while (!facts) {
      simulation.step()
      facts = noteTick(doings, simulation, table.hold)
      if (doings.ticks % ticksAPose === 0) poses.push(poseIn(simulation))
    }
    coins.push(payFor(table.pay, facts))
    ended = table.bumpEnds && facts.bump > 0
  }
  return { doings, ended, watched: { poses, coins, posesAMove: table.hold / ticksAPose } }
}

function poseIn(simulation: Simulation): Pose {
  const { x, y, heading } = simulation.state.robots[0]!
  return { x, y, heading: (heading * 180) / Math.PI }
}
