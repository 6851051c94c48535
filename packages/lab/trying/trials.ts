import type { Trying } from '@botgarten/blocks'
import {
  bestAction,
  isOf,
  problemOf,
  stateOf,
  type TableBrain,
  type Trial,
} from '@botgarten/learning/q-senses'
import { stream, type StreamState } from '@botgarten/numbers'
import { tryingIn, type Program } from '@botgarten/programs'
import { stopMotors, TICKS_PER_SECOND, type Simulation } from '@botgarten/simulation'
import { drive, readingsOf, touchesIn } from './body.ts'
import { beginTry, learnedOf, tryTick, type TryState } from './try.ts'

/** Learned tables by the block that learned them. */
export type Tables = { readonly [id: string]: TableBrain }

/** One robot's trying, as plain data. */
export interface RobotTry {
  learning: TryState | null
  /** Draws between actions that are worth the same. */
  readonly ties: StreamState
  /** What the table made it do last; null: it has not driven by one. */
  doing: { readonly table: string; readonly state: number; readonly action: number } | null
}

/** Ticks of so many simulated minutes. */
export const ticksOf = (minutes: number): number => Math.round(minutes * 60 * TICKS_PER_SECOND)

/** Has a table been learned by this trial, and for as long? */
export const isLearned = (table: TableBrain | undefined, trial: Trial, minutes: number): boolean =>
  table !== undefined && isOf(trial, table) && (table.moves + 1) * table.hold > ticksOf(minutes)

/** What robots of a run learn by trying. */
export class Trials {
  readonly #simulation: Simulation
  state: { readonly [robot: number]: RobotTry } = {}
  tables: Tables

  constructor(simulation: Simulation, tables: Tables) {
    this.#simulation = simulation
    this.tables = tables
  }

  isTrying(robot: number): boolean {
    return (this.state[robot]?.learning ?? null) !== null
  }

  /** The table by which a robot drives; null: it learns, or drives by none. */
  drivesBy(robot: number): TableBrain | null {
    const { learning = null, doing = null } = this.state[robot] ?? {}
    return learning || !doing ? null : (this.tables[doing.table] ?? null)
  }

  #of(robot: number): RobotTry {
    const known = this.state[robot]
    if (known) return known
    const ties = stream(1, `act/${this.#simulation.world.robots[robot]!.id}`)
    const fresh: RobotTry = { learning: null, ties, doing: null }
    this.state = { ...this.state, [robot]: fresh }
    return fresh
  }

  /** What blocks of a robot's program do. */
  tryingOf(robot: number, program: Program): Trying {
    const outline = tryingIn(program)
    if (!outline) return { learn: () => true, act: () => 'tryNotLearned' }
    const { id, trial, minutes } = outline
    const problem = problemOf(trial)
    return {
      learn: () => problem ?? (isLearned(this.tables[id], trial, minutes) || this.#tick(robot, outline)),
      act: () => this.#act(robot, id),
    }
  }

  #tick(robot: number, { id, trial, minutes }: NonNullable<ReturnType<typeof tryingIn>>): boolean {
    const own = this.#of(robot)
    own.learning ??= beginTry(trial)
    tryTick(own.learning, this.#simulation, robot)
    if (own.learning.total < ticksOf(minutes)) return false
    this.tables = { ...this.tables, [id]: learnedOf(own.learning) }
    own.learning = null
    const { id: name, pose } = this.#simulation.world.robots[robot]!
    stopMotors(this.#simulation, robot)
    this.#simulation.place(name, pose)
    return true
  }

  #act(robot: number, id: string): number | string {
    const table = this.tables[id]
    if (!table) return 'tryNotLearned'
    const simulation = this.#simulation
    const state = stateOf(table, readingsOf(simulation, robot, table), touchesIn(simulation, robot))
    const own = this.#of(robot)
    const action = bestAction(table.q, state, table.actions.length, own.ties)
    own.doing = { table: id, state, action }
    drive(simulation, robot, table.actions[action]!)
    return table.hold
  }
}
