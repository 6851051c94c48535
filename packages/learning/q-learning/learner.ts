import { fastStream, type FastStream } from '@botgarten/numbers'
import { refuseOutside } from '../parameters.ts'
import { parameters } from './settings.ts'
import type { Decay, Ending, QState, Settings } from './types.ts'
import type { QWorld } from './world.ts'

/** A learner at work. Its typed arrays and numbers are written by update.ts alone. */
export interface QLearner {
  readonly world: QWorld
  readonly settings: Settings
  readonly q: Float64Array
  readonly tries: Uint32Array
  readonly stream: FastStream
  /** −1: a new episode begins. */
  state: number
  /** −1: nothing is chosen yet. */
  chosen: number
  chosenExplores: boolean
  steps: number
  episodes: number
  episodeSteps: number
  goals: number
  alpha: number
  epsilon: number
  /** What α and ε are times after every episode. */
  readonly alphaFactor: number
  readonly epsilonFactor: number
  /** The last step: see QTrace. */
  readonly last: Last
}

/** Written again by every step, so that no step allocates. `move` −1: no action was open. */
interface Last {
  readonly draws: Float64Array
  from: number
  teleported: boolean
  explores: boolean
  fell: boolean
  action: number
  to: number
  reward: number
  before: number
  bestNext: number
  after: number
  alpha: number
  ends: Ending | null
}

const noStep = (): Last => ({
  ...{
    draws: new Float64Array(2),
    from: 0,
    teleported: false,
    explores: false,
    fell: false,
    action: -1,
    to: 0,
    ends: null,
  },
  ...{ reward: 0, before: 0, bestNext: 0, after: 0, alpha: 0 },
})

/** Steps of an episode of the standard rules at most. */
export const longestEpisode = ({ states }: QWorld) => 20 * states

/**
 * A learner that knows nothing: Q = 0.
 * @param stream 4 words of a random stream of its own: `stream(seed, 'learn/…')`
 * @throws RangeError for a parameter outside the schema
 */
export function createLearner(world: QWorld, settings: Settings, stream: readonly number[]): QLearner {
  refuseOutside(parameters, settings)
  return {
    ...{ world, settings },
    q: new Float64Array(world.meant.length),
    tries: new Uint32Array(world.meant.length),
    stream: fastStream(stream),
    ...{ state: -1, chosen: -1, chosenExplores: false, steps: 0, episodes: 0, episodeSteps: 0, goals: 0 },
    ...{ alpha: settings.alpha, epsilon: settings.rho },
    alphaFactor: factorOf(settings.alphaDecay),
    epsilonFactor: factorOf(settings.rhoDecay),
    last: noStep(),
  }
}

/** The learner's state as plain data (running.md 2). */
export function saveLearner(learner: QLearner): QState {
  const { q, tries, state, chosen, stream } = learner
  return {
    ...{ q: [...q], tries: [...tries], stream: [...stream], ...countsOf(learner) },
    state: state < 0 ? null : state,
    chosen: chosen < 0 ? null : chosen,
  }
}

/** Goes on from a saved state. @throws RangeError where it does not fit this world */
export function restoreLearner(learner: QLearner, saved: QState): void {
  const { length } = learner.q
  if (saved.q.length !== length || saved.tries.length !== length)
    throw new RangeError(`This state knows ${saved.q.length} moves, the map has ${length}.`)
  if (saved.q.some((value) => !Number.isFinite(value))) throw new RangeError('A value is not a number.')
  if ((saved.state ?? 0) >= learner.world.states || (saved.chosen ?? 0) >= Math.max(1, length))
    throw new RangeError('This state stands on a station that is not there.')
  learner.q.set(saved.q)
  learner.tries.set(saved.tries)
  learner.stream.set(saved.stream)
  learner.state = saved.state ?? -1
  learner.chosen = saved.chosen ?? -1
  Object.assign(learner, countsOf(saved))
}

type Count = 'chosenExplores' | 'steps' | 'episodes' | 'episodeSteps' | 'goals' | 'alpha' | 'epsilon'
const countsOf = (from: Pick<QState, Count>): Pick<QState, Count> => {
  const { chosenExplores, steps, episodes, episodeSteps, goals, alpha, epsilon } = from
  return { chosenExplores, steps, episodes, episodeSteps, goals, alpha, epsilon }
}

const factorOf = (decay: Decay | undefined) => (decay?.kind === 'episodes' ? decay.factor : 1)
