import {
  createLearner,
  episodeLog,
  greedyAction,
  layOutWorld,
  learnedPath,
  lengthOf,
  policy,
  reachesGoal,
  runEpisodes,
  shortestLength,
  shortestPath,
  type EpisodeLog,
  type QLearner,
  type QWorld,
  type Settings,
} from '@botgarten/learning/q-learning'
import { stream } from '@botgarten/numbers'
import { pointsOf } from './points.ts'
import type { Lane, Race, RunRecord, WayThen } from './types.ts'

/** What a racer learns with: dice alone explore always, who takes the best so far never. */
export function settingsOf({ racer, alpha, gamma, nu, rho }: Lane): Settings {
  const explores = racer === 'random' ? 1 : racer === 'best' ? 0 : rho
  return {
    ...{ rules: 'standard', algorithm: racer === 'sarsa' ? 'sarsa' : 'q' },
    ...{ alpha, gamma, nu, rho: explores },
  }
}

/** The dice of a lane, counted from 1, in a run, counted from 1. */
const streamOf = ({ seed, sameDice }: Pick<Race, 'seed' | 'sameDice'>, lane: number, run: number) =>
  stream(seed, `race/${sameDice ? 1 : lane}/${run}`)

/**
 * One run of one lane: the same numbers in whatever thread and order.
 * @param lane, run counted from 1
 */
export function runLane(race: Race, lane: number, run: number): RunRecord {
  const world = layOutWorld(race.task)
  const learner = createLearner(world, settingsOf(race.lanes[lane - 1]!), streamOf(race, lane, run))
  const log = episodeLog(race.tries)
  const points = pointsOf(race.tries)
  const good = goodWay(world)
  let first: number | null = null
  const ways = points.map((point) => {
    first ??= searchUntil(learner, point, log, good)
    runEpisodes(learner, point - learner.episodes, log)
    return wayOf(learner)
  })
  return {
    ...{ moves: sumsAt(points, log.steps), stars: sumsAt(points, log.rewards) },
    ...{ falls: sumsAt(points, log.falls), ways, first },
    reaches: world.isSlippery ? reachesGoal(world, policy(learner)) : null,
  }
}

/** Runs on to a point at most. Returns after how many moves a try has ended with a good way; null: none has. */
function searchUntil(learner: QLearner, point: number, log: EpisodeLog, good: GoodWay): number | null {
  if (learner.world.isSlippery) return null
  while (learner.episodes < point) {
    runEpisodes(learner, 1, log)
    // The quick question first: it is asked after every try.
    if (!arrives(learner, good.moves)) continue
    const { states } = learnedPath(learner)
    if (states && good.is(states)) return learner.steps
  }
  return null
}

interface GoodWay {
  /** It has so many moves at most. */
  readonly moves: number
  is(states: readonly number[]): boolean
}

/** What a shortest way is: by length where length counts, else by sections. */
function goodWay(world: QWorld): GoodWay {
  if (world.task.lengthCost) {
    const shortest = shortestLength(world) ?? 0
    return { moves: world.states, is: (states) => lengthOf(world, states) <= shortest + 1e-6 }
  }
  const shortest = shortestPath(world) ?? 0
  return { moves: shortest - 1, is: ({ length }) => length === shortest }
}

/** Do the best actions lead from the start to a goal within so many moves? */
function arrives(learner: QLearner, moves: number): boolean {
  const { world, tries } = learner
  let state = world.start
  for (let move = 0; move < moves && world.isGoal[state] === 0; move++) {
    const action = greedyAction(learner, state)
    if (action < 0 || tries[action] === 0) return false
    state = world.leads[action]!
  }
  return world.isGoal[state] === 1
}

function wayOf(learner: QLearner): WayThen {
  const { states, reason } = learnedPath(learner)
  return states ? { states } : { reason }
}

function sumsAt(points: readonly number[], values: ArrayLike<number>): number[] {
  let [sum, done] = [0, 0]
  return points.map((point) => {
    while (done < point) sum += values[done++]!
    return sum
  })
}
