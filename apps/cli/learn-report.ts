import {
  doubtAt,
  planOf,
  type Decay,
  type LearnedPath,
  type QLearner,
  type Plan,
  type Settings,
} from '@botgarten/learning/q-learning'
import { message } from './words.ts'

/** Why there is no learned way, and the station that it is about. */
interface NotLearned {
  readonly reason: LearnedPath['reason']
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
export function notLearnedIn(way: LearnedPath, plan: PlanIn | null): NotLearned | null {
  if (way.states) return null
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

export function sentenceOf(report: Report): string {
  const { bestWay, reason, walked, notLearned, plan, moves, episodes, firstShortestMove: first } = report
  const after = message('learned.after', { moves, episodes })
  if (plan) return planSentence(after, plan, notLearned)
  const way = bestWay && joined(bestWay)
  if (notLearned && isDoubt(notLearned.reason)) return doubtSentence(after, notLearned, way)
  if (way === null) return message('learned.noWay', { after, reason, walked: joined(walked) })
  return first === null
    ? message('learned.way', { after, way })
    : message('learned.wayFirst', { after, way, first })
}

const joined = (stations: readonly number[]) => stations.join(' → ')

const doubts = ['alike', 'unpaid', 'untried'] as const
const isDoubt = (reason: LearnedPath['reason']): reason is (typeof doubts)[number] =>
  doubts.some((doubt) => doubt === reason)

function doubtSentence(after: string, { reason, station }: NotLearned, way: string | null): string {
  const doubt = message(`learned.${reason as (typeof doubts)[number]}`)
  const notYet = message('learned.notYet', { after, reason, station, doubt })
  return way === null ? notYet : message('learned.notYetShown', { notYet, way })
}

function planSentence(after: string, plan: PlanSaid, notLearned: NotLearned | null): string {
  const judged = message('learned.plan', {
    after,
    expected: numberSaid(plan.expectedReturn),
    best: numberSaid(plan.bestReturn),
    percent: (100 * plan.reachesGoal).toFixed(1),
  })
  const moves = Object.entries(plan.policy)
    .map(([station, move]) => `${station} ${move}`)
    .join(', ')
  const sentence =
    notLearned === null ? judged : message('learned.planNotYet', { plan: judged, ...notLearned })
  return notLearned !== null && moves === ''
    ? sentence
    : message('learned.planMoves', { plan: sentence, moves })
}

const numberSaid = (value: number | null) =>
  value === null ? message('learned.noEnd') : Number(value.toPrecision(4)).toString()
