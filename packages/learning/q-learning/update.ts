import { fastDraw } from '@botgarten/numbers'
import { longestEpisode, type QLearner } from './learner.ts'
import type { Ending } from './types.ts'

/**
 * One move; what happened stands in `learner.last`. Nothing is allocated. Draws in the order of running.md 13: ε, ν,
 * both always; the state if it is drawn; the action if it explores, or one of several best by the standard rules; the
 * outcome of a slippery action; for SARSA the ε of the next action and that action.
 */
export function update(learner: QLearner): void {
  const { world, settings, q, stream, last } = learner
  const epsilon = (last.draws[0] = fastDraw(stream))
  const nu = (last.draws[1] = fastDraw(stream))
  const isStudy = settings.rules === 'study'
  last.teleported = findStart(learner, nu, isStudy)
  const from = (last.from = last.to = learner.state)
  const first = world.first[from]!
  const count = world.first[from + 1]! - first
  learner.steps++
  learner.episodeSteps++
  if (count === 0) return stayStuck(learner)

  const reuses = learner.chosen >= 0
  last.explores = reuses ? learner.chosenExplores : epsilon < learner.epsilon
  const taken = (last.action = reuses ? learner.chosen : choose(learner, from, last.explores))
  learner.chosen = -1
  const end = world.isSlippery ? outcomeOf(learner, taken) : taken
  const to = (last.to = world.to[end]!)
  last.ends = endingAt(learner, to, isStudy)
  const isLast = last.ends !== null && last.ends !== 'limit'
  last.reward = world.reward[end]!
  last.fell = world.isFall[end] === 1
  last.bestNext = isLast ? 0 : settings.algorithm === 'q' ? bestValue(learner, to) : valueOfNext(learner, to)

  const tries = (learner.tries[taken] = learner.tries[taken]! + 1)
  last.alpha = settings.alphaDecay?.kind === 'visits' ? (learner.alpha * 10) / (9 + tries) : learner.alpha
  last.before = q[taken]!
  last.after = (1 - last.alpha) * last.before + last.alpha * (last.reward + settings.gamma * last.bestNext)
  q[taken] = last.after

  learner.state = to
  if (world.isGoal[to] === 1) learner.goals++
  if (last.ends !== null) endEpisode(learner, -1)
  else if (isStudy) endEpisode(learner, to)
}

/** Settles where this step starts. Returns whether it was put somewhere by teleporting. */
function findStart(learner: QLearner, nu: number, isStudy: boolean): boolean {
  const { world, stream } = learner
  const targets = isStudy ? world.states : world.open.length
  const teleports = nu < learner.settings.nu && targets > 0
  if (!teleports && learner.state >= 0) return false
  learner.chosen = -1
  if (!teleports && !isStudy) learner.state = world.start
  else {
    const index = Math.floor(fastDraw(stream) * targets)
    learner.state = isStudy ? index : world.open[index]!
  }
  return teleports
}

/** An action of this state: any of them, or one of the best. */
function choose({ world, settings, q, stream }: QLearner, state: number, explores: boolean): number {
  const first = world.first[state]!
  const end = world.first[state + 1]!
  if (explores) return first + Math.floor(fastDraw(stream) * (end - first))
  let best = first
  let ties = 1
  for (let other = first + 1; other < end; other++) {
    if (q[other]! > q[best]!) {
      best = other
      ties = 1
    } else if (q[other] === q[best]) ties++
  }
  if (ties === 1 || settings.rules === 'study') return best
  let skip = Math.floor(fastDraw(stream) * ties)
  for (let other = best; ; other++) if (q[other] === q[best] && skip-- === 0) return other
}

function outcomeOf({ world, stream }: QLearner, taken: number): number {
  let end = world.outcome[taken]!
  if (world.outcome[taken + 1]! - end === 1) return end
  const drawn = fastDraw(stream)
  while (drawn >= world.upTo[end]!) end++
  return end
}

function bestValue({ world: { first }, q }: QLearner, state: number): number {
  const end = first[state + 1]!
  let best = q[first[state]!]!
  for (let other = first[state]! + 1; other < end; other++) if (q[other]! > best) best = q[other]!
  return best
}

/** SARSA settles here what it will do next. */
function valueOfNext(learner: QLearner, state: number): number {
  learner.chosenExplores = fastDraw(learner.stream) < learner.epsilon
  learner.chosen = choose(learner, state, learner.chosenExplores)
  return learner.q[learner.chosen]!
}

/** An episode that ends by its length alone goes on in value: only here does it stop (Pardo et al. 2018). */
function endingAt(learner: QLearner, to: number, isStudy: boolean): Ending | null {
  const { world } = learner
  if (!isStudy && world.terminal[to] === 1) return world.isGoal[to] === 1 ? 'goal' : 'terminal'
  if (world.first[to] === world.first[to + 1]) return 'deadEnd'
  return !isStudy && learner.episodeSteps >= longestEpisode(world) ? 'limit' : null
}

function stayStuck(learner: QLearner): void {
  const { last } = learner
  last.action = -1
  last.explores = last.fell = false
  last.reward = last.before = last.bestNext = last.after = last.alpha = 0
  last.ends = 'deadEnd'
  endEpisode(learner, -1)
}

function endEpisode(learner: QLearner, state: number): void {
  learner.state = state
  if (state < 0) learner.chosen = -1
  learner.episodes++
  learner.episodeSteps = 0
  learner.alpha *= learner.alphaFactor
  learner.epsilon *= learner.epsilonFactor
}
