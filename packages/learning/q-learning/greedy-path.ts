import type { QLearner } from './learner.ts'

/** The path that always takes the best action; without one, an honest reason. States are in the order walked. */
export type GreedyPath =
  | { readonly states: readonly number[]; readonly reason: 'found' | 'startIsGoal' }
  | {
      readonly states: null
      readonly reason: 'circle' | 'deadEnd' | 'unknown' | 'neverReached'
      /** How far it got; at a circle the last state is the one where it closes. */
      readonly walked: readonly number[]
    }

/** Of equally good actions the first: what is drawn must not change from look to look. */
export function greedyAction({ world: { first }, q }: Pick<QLearner, 'world' | 'q'>, state: number): number {
  const end = first[state + 1]!
  let best = first[state]!
  if (best === end) return -1
  for (let action = best + 1; action < end; action++) if (q[action]! > q[best]!) best = action
  return best
}

/** By state the action it would take now; −1: there is none. */
export const policy = (learner: QLearner): number[] =>
  Array.from({ length: learner.world.states }, (_, state) => greedyAction(learner, state))

/** Walks the best way from start to goal, as far as it is known. Slippery actions are walked as they are meant. */
export function greedyPath(learner: QLearner): GreedyPath {
  const { world, tries, goals } = learner
  const walked = [world.start]
  if (world.isGoal[world.start] === 1) return { states: walked, reason: 'startIsGoal' }
  const none = (reason: 'circle' | 'deadEnd' | 'unknown') =>
    ({ states: null, reason: goals === 0 ? 'neverReached' : reason, walked }) as const
  const seen = new Set(walked)
  for (let state = world.start; ;) {
    const action = greedyAction(learner, state)
    if (action < 0) return none('deadEnd')
    if (tries[action] === 0) return none('unknown')
    state = world.leads[action]!
    walked.push(state)
    if (world.isGoal[state] === 1) return { states: walked, reason: 'found' }
    if (seen.has(state)) return none('circle')
    seen.add(state)
  }
}
