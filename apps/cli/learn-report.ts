import {
  doubtAt,
  planOf,
  type Decay,
  type LearnedWay,
  type QLearner,
  type Plan,
  type Settings,
} from '@botgarten/learning/q-learning'

/** Why there is no learned way, and the station that it is about. */
interface NotLearned {
  readonly reason: LearnedWay['reason']
  readonly station: number
}

/** Where moves are by chance: what the learner would do, and what that may expect. */
interface PlanSaid {
  /** By station the name of the best move. */
  readonly policy: { readonly [station: string]: string }
  readonly expectedReturn: number | null
  readonly bestReturn: number | null
  readonly reachesGoal: number
}

interface PlanIn {
  readonly said: PlanSaid
  readonly doubt: NotLearned | null
}

/** Null where every move leads where it is meant to. */
export function planIn(learner: QLearner): PlanIn | null {
  const { world } = learner
  if (!world.isSlippery) return null
  const plan = planOf(learner)
  const said = {
    policy: policyOf(plan, learner),
    ...{ expectedReturn: plan.expected, bestReturn: plan.best, reachesGoal: plan.reaches },
  }
  if (plan.doubt === null) return { said, doubt: null }
  return { said, doubt: { reason: doubtAt(learner, plan.doubt)!, station: plan.doubt } }
}

const policyOf = ({ policy }: Plan, { world, q }: QLearner): PlanSaid['policy'] =>
  Object.fromEntries(
    policy.flatMap((move, station) =>
      move >= 0 && world.terminal[station] === 0 && q[move] !== 0
        ? [[station, world.names[move]!.slice(`${station}-`.length)]]
        : [],
    ),
  )

/** Null: a way is learned or, where moves are by chance, a plan. */
export function notLearnedIn(way: LearnedWay, plan: PlanIn | null): NotLearned | null {
  if (way.stations) return null
  if (way.reason !== 'neverReached' && plan) return plan.doubt
  return { reason: way.reason, station: way.walked.at(-1)! }
}

/** What it was learned with; how α and ρ fall by name and by formula. */
export const settingsSaid = ({ alphaDecay, rhoDecay, ...settings }: Settings) => ({
  ...settings,
  alphaDecay: decaySaid('alpha', alphaDecay),
  rhoDecay: decaySaid('rho', rhoDecay),
})

function decaySaid(name: string, decay: Decay = { kind: 'constant' }) {
  if (decay.kind === 'visits') return { ...decay, formula: `${name} * 10 / (9 + n), n-th update of a value` }
  if (decay.kind === 'episodes')
    return { ...decay, formula: `${name} * ${decay.factor} ^ n, n episodes done before` }
  return { ...decay, formula: name }
}

interface Report {
  readonly bestWay: readonly number[] | null
  readonly reason: string
  readonly walked: readonly number[]
  readonly notLearned: NotLearned | null
  readonly plan?: PlanSaid
  readonly moves: number
  readonly episodes: number
  readonly firstShortestMove: number | null
}

const doubts: { readonly [reason in LearnedWay['reason']]?: string } = {
  alike: 'all roads are still alike',
  unpaid: 'no road has paid yet',
  untried: 'a road was never tried that is worth as much as the best',
}

export function sentenceOf(report: Report): string {
  const { bestWay: way, reason, walked, notLearned, plan, moves, episodes, firstShortestMove } = report
  const after = `After ${moves} moves in ${episodes} episodes`
  if (plan) return `${after}: ${planSentence(plan, notLearned)}`
  const doubt = notLearned && doubts[notLearned.reason]
  if (notLearned && doubt) {
    const shown = way ? `; the first of equal roads would give ${way.join(' → ')}` : ''
    return `${after}: no way learned yet (${notLearned.reason}): at ${notLearned.station} ${doubt}${shown}`
  }
  if (way === null) return `${after}: no way yet (${reason}): ${walked.join(' → ')}`
  const first =
    firstShortestMove === null ? '' : `, a shortest one first shown after move ${firstShortestMove}`
  return `${after}: ${way.join(' → ')}${first}`
}

function planSentence(plan: PlanSaid, notLearned: NotLearned | null): string {
  const { policy, expectedReturn, bestReturn, reachesGoal } = plan
  const number = (value: number | null) =>
    value === null ? 'no end' : Number(value.toPrecision(4)).toString()
  const moves = Object.entries(policy)
    .map(([station, move]) => `${station} ${move}`)
    .join(', ')
  const judged = `moves are by chance, so there is no sure way; the policy expects ${number(expectedReturn)} (at best ${number(bestReturn)}) and gets to the goal in ${(100 * reachesGoal).toFixed(1)} of 100 attempts`
  if (notLearned === null) return `${judged}: ${moves}`
  return `${judged}; not learned yet (${notLearned.reason} at ${notLearned.station})${moves === '' ? '' : `: ${moves}`}`
}
