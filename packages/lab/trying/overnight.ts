import { bestAction, stateOf, type TableBrain, type Trial } from '@botgarten/learning/q-senses'
import { stream } from '@botgarten/numbers'
import { createSimulation, TICKS_PER_SECOND, type Floor, type World } from '@botgarten/simulation'
import { drive, readingsOf, touchesIn } from './body.ts'
import { beginTry, tryTick, type TryState } from './try.ts'

/** A robot that tries on in a world of its own, as fast as it can. */
export interface Night {
  readonly state: TryState
  /** Lets it try for so many ticks more. */
  advance(ticks: number): void
}

/** The same tries as in the lab, bit for bit; the programs of other robots stand still. `seed`: of the world's noise. */
export function beginNight(world: World, floor: Floor, trial: Trial, robot = 0, seed = 1): Night {
  const simulation = createSimulation(world, floor, seed)
  const state = beginTry(trial)
  return {
    state,
    advance(ticks) {
      const until = state.total + ticks
      while (state.total < until) {
        tryTick(state, simulation, robot)
        simulation.step()
      }
    },
  }
}

/** How a table drives: bumps, and the way of the middle of the axle in cm a minute. */
export interface Ride {
  readonly bumps: number
  readonly cm: number
}

/**
 * Drives by the table alone, without exploring; of equal actions one by chance. From where the world has the robot, up to the
 * end of the seconds or, with `untilBump`, to the first bump.
 */
export function rideBy(
  table: TableBrain,
  world: World,
  floor: Floor,
  seconds: number,
  untilBump = false,
): Ride {
  const robot = 0
  const simulation = createSimulation(world, floor, 1)
  const ties = stream(1, `act/${world.robots[robot]!.id}`)
  const body = simulation.state.robots[robot]!
  let [bumps, way, touched] = [0, 0, false]
  for (let tick = 0; tick < seconds * TICKS_PER_SECOND; tick++) {
    if (tick % table.hold === 0) {
      const state = stateOf(table, readingsOf(simulation, robot, table), touchesIn(simulation, robot))
      drive(simulation, robot, table.actions[bestAction(table.q, state, table.actions.length, ties)]!)
    }
    const { x, y } = body
    simulation.step()
    const [dx, dy] = [body.x - x, body.y - y]
    way += Math.sqrt(dx * dx + dy * dy)
    const touches = touchesIn(simulation, robot)
    if (touches && !touched) bumps++
    touched = touches
    if (untilBump && touches) break
  }
  return { bumps, cm: (way * 60) / seconds }
}
