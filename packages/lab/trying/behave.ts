import {
  bestAction,
  payKinds,
  stateOf,
  type Facts,
  type PayKind,
  type TableBrain,
} from '@botgarten/learning/q-senses'
import { stream } from '@botgarten/numbers'
import {
  createSimulation,
  TICKS_PER_SECOND,
  type Floor,
  type Pose,
  type Simulation,
  type World,
} from '@botgarten/simulation'
import { drive, factsOf, readingsOf, sightOf, tileAt, touchesIn } from './body.ts'

/** What a robot does with a frozen table. */
export interface Behaviour {
  /** Everything that can be paid for, added up, a minute. */
  readonly facts: Facts
  /** Squares of 40 cm where it has been, from one start in the mean. */
  readonly tiles: number
  /** Percent of the time in which the body touches something. */
  readonly touching: number
  /** From how many starts a bump ended the try, where bumps do. */
  readonly ended: number
}

/** One drive, to be watched: a pose every 3rd tick. */
export type Watched = readonly Pose[]
export const ticksAPose = 3

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
  const ticks = sum(drives.map((one) => one.ticks))
  const factsIn = (kind: PayKind) => sum(drives.map(({ facts }) => sum(facts.map((fact) => fact[kind]))))
  // What a bump ends brings and costs nothing more, as in a try.
  const perMinute = 60 / (seconds * drives.length)
  const facts = Object.fromEntries(payKinds.map((kind) => [kind, factsIn(kind) * perMinute])) as Facts
  return {
    behaviour: {
      facts,
      tiles: sum(drives.map(({ tiles }) => tiles.size)) / drives.length,
      touching: (100 * sum(drives.map(({ touching }) => touching))) / ticks,
      ended: drives.filter(({ ended }) => ended).length,
    },
    watched: drives.map(({ poses }) => poses),
  }
}

const sum = (values: readonly number[]) => values.reduce((total, value) => total + value, 0)

function driveOf(table: TableBrain, simulation: Simulation, seconds: number) {
  const ties = stream(1, `act/${simulation.world.robots[0]!.id}`)
  const facts: Facts[] = []
  const poses: Pose[] = [poseIn(simulation)]
  const tiles = new Set([tileAt(sightOf(simulation, 0))])
  let [ticks, touching, ended] = [0, 0, false]
  while (ticks < seconds * TICKS_PER_SECOND && !ended) {
    const before = sightOf(simulation, 0)
    const state = stateOf(table, readingsOf(simulation, 0, table), touchesIn(simulation, 0))
    drive(simulation, 0, table.actions[bestAction(table.q, state, table.actions.length, ties)]!)
    let bumped = false
    for (let held = 0; held < table.hold; held++) {
      simulation.step()
      bumped ||= touchesIn(simulation, 0)
      touching += Number(touchesIn(simulation, 0))
      if (++ticks % ticksAPose === 0) poses.push(poseIn(simulation))
    }
    const now = sightOf(simulation, 0)
    const isNew = !tiles.has(tileAt(now))
    facts.push(factsOf(before, now, bumped, isNew))
    tiles.add(tileAt(now))
    ended = table.bumpEnds && bumped
  }
  return { ticks, facts, poses, tiles, touching, ended }
}

function poseIn(simulation: Simulation): Pose {
  const { x, y, heading } = simulation.state.robots[0]!
  return { x, y, heading: (heading * 180) / Math.PI }
}
