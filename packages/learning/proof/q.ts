import type { QLearner } from '../q-learning/learner.ts'
import { run, step } from '../q-learning/step.ts'
import type { QTrace } from '../q-learning/types.ts'
import { mostNumbers, type Proof } from './types.ts'

/** What was met in one step: its place in the table, the reward, what comes after, and α. */
export type Met = readonly [
  state: number,
  action: number,
  reward: number,
  /** −1: nothing comes after. */
  next: number,
  /** The action that is taken there (SARSA); −1: the best one. */
  chosen: number,
  alpha: number,
]

const numbersOfStep = 6
const mostSteps = Math.floor(mostNumbers / numbersOfStep)

/** A table that learned by trying, on a map or with sensors. */
export interface Tried {
  /** Actions of state s are those from `first[s]` to below `first[s + 1]`. */
  readonly first: readonly number[]
  readonly gamma: number
  /** The table before the first of these steps, by action. */
  readonly q: readonly number[]
  readonly steps: readonly Met[]
}

/** What one action is worth after these steps. `before`: steps that are left out. */
export const triedProof = (tried: Tried, action: number, number: number, before = 0): Proof => ({
  method: 'q',
  ...{ number, before },
  data: { ...tried, action },
  learn: `Q, first = np.array(data["q"], dtype=float), data["first"]
for state, action, reward, after, chosen, alpha in data["steps"]:
    if after < 0:
        best = 0.0
    elif chosen >= 0:
        best = Q[chosen]
    else:
        best = Q[first[after]:first[after + 1]].max()
    Q[action] = (1 - alpha) * Q[action] + alpha * (reward + data["gamma"] * best)`,
  show: 'number = Q[data["action"]]',
})

/**
 * What an action of a map is worth after so many steps.
 * @param learner before its first step: it learns here
 */
export function qProof(learner: QLearner, steps: number, action: number): Proof {
  const before = Math.max(0, steps - mostSteps)
  run(learner, before)
  const { world, settings } = learner
  const start = [...learner.q]
  const met: Met[] = []
  while (learner.steps < steps) {
    const q = learner.q.slice()
    const trace = step(learner)
    if (trace.decision !== null) met.push(metIn(learner, q, trace))
  }
  const tried = { first: [...world.first], gamma: settings.gamma, q: start, steps: met }
  return triedProof(tried, action, learner.q[action]!, before)
}

/** `q`: the table before the step. */
function metIn({ world, settings }: QLearner, q: Float64Array, trace: QTrace): Met {
  const { from, action, reward, to, ends, alpha, bestNext } = trace
  const isLast = ends !== null && ends !== 'limit'
  const isSarsa = settings.algorithm === 'sarsa' && !isLast
  const chosen = isSarsa ? q.indexOf(bestNext, world.first[to]) : -1
  return [from, action, reward, isLast ? -1 : to, chosen, alpha]
}
