import { emptyTable, isOf, problemOf, stateOf, statesOf } from '@botgarten/learning/q-senses'
import type { Minute, Problem, TableBrain, TryTrace } from '@botgarten/learning/q-senses'
import { tryingIn, type TryOutline } from '@botgarten/programs'
import type { Run } from '../run.ts'
import { readingsOf, touchesIn } from './body.ts'
import { tableOf, type TryState } from './try.ts'

/** What a robot learns by trying at the moment that is shown. Nothing of it is the run's own: it stays as it is. */
export interface TryView {
  /** What the program's blocks say now. */
  readonly outline: TryOutline
  /** Why nothing can be learned. */
  readonly problem: Problem | null
  /** Learned so far, learned before, or empty. It holds the trial by which it was learned. */
  readonly table: TableBrain
  /** `fresh`: nothing is learned · `trying` · `learned` · `other`: learned before the blocks were changed. */
  readonly stage: 'fresh' | 'trying' | 'learned' | 'other'
  /** Where it stands in the table; null: not known. */
  readonly state: number | null
  /** What it is doing, by which of the two; null: nothing that it has chosen. */
  readonly action: { readonly index: number; readonly decision: TryTrace['decision'] } | null
  /** The last move that was learned from. */
  readonly last: TryTrace | null
  /** Whole simulated minutes of what is being learned, or of the table as far as they are known. */
  readonly curve: readonly Minute[]
  /** While it tries: the minute under way, and ticks in all. */
  readonly minute: Minute
  readonly total: number
  /** Index of the start from which it could not get away; −1: none. */
  readonly stuckAt: number
}

const nothingYet = {
  ...{ action: null, last: null, minute: { pay: 0, bumps: 0 }, total: 0, stuckAt: -1 },
} as const

/**
 * @param reads may the sensors be asked? Not while a program runs: a reading may draw noise
 * @returns null where no block tries
 */
export function tryViewOf(
  { trials, simulation, robots }: Run,
  robot: number,
  reads: boolean,
): TryView | null {
  const outline = robots[robot] ? tryingIn(robots[robot].program) : null
  if (!outline) return null
  const { learning, doing } = trials.state[robot] ?? { learning: null, doing: null }
  const problem = problemOf(outline.trial)
  if (learning) return { outline, problem, ...whileTrying(learning) }
  const known = trials.tables[outline.id]
  const table = known ?? emptyOf(outline, problem)
  const read = () => stateOf(table, readingsOf(simulation, robot, table), touchesIn(simulation, robot))
  return {
    ...{ ...nothingYet, outline, problem, table, stage: stageOf(outline, known) },
    curve: table.curve ?? [],
    state: reads && table.q.length > 0 ? read() : (doing?.state ?? null),
    action: reads || !doing ? null : { index: doing.action, decision: 'exploit' },
  }
}

function whileTrying(learning: TryState): Omit<TryView, 'outline' | 'problem'> {
  const { state, action, explores, last, curve, minute, total, stuckAt } = learning
  return {
    ...{ stage: 'trying', table: tableOf(learning), last, minute, total, stuckAt },
    curve: [...curve],
    state: state < 0 ? null : state,
    action: state < 0 ? null : { index: action, decision: explores ? 'explore' : 'exploit' },
  }
}

function stageOf({ trial, minutes }: TryOutline, table: TableBrain | undefined): TryView['stage'] {
  if (!table) return 'fresh'
  // A program that only drives takes a table as it is.
  return minutes === 0 || isOf(trial, table) ? 'learned' : 'other'
}

/** Of a trial that cannot be learned there is no table: it might be huge. */
function emptyOf({ trial }: TryOutline, problem: Problem | null): TableBrain {
  const states = problem === 'tryManyStates' || problem === 'tryManySenses' ? 0 : statesOf(trial)
  return { ...trial, kind: 'table', ...emptyTable(states, trial.actions.length) }
}
