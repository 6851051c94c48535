import { fastStream, type FastStream } from '@botgarten/numbers'
import { refuseOutside } from '../parameters.ts'
import { parameters } from './settings.ts'
import type { Decay, Ending, QState, Settings } from './types.ts'
import type { QWorld } from './world.ts'

/** A learner at work. Its typed arrays and numbers are written by move.ts alone. */
export interface QLearner {
  readonly world: QWorld
  readonly settings: Settings
  readonly q: Float64Array
  readonly tries: Uint32Array
  readonly stream: FastStream
  /** −1: a new episode begins. */
  station: number
  /** −1: nothing is chosen yet. */
  chosen: number
  chosenExplores: boolean
  moves: number
  episodes: number
  episodeMoves: number
  goals: number
  alpha: number
  rho: number
  /** What α and ρ are times after every episode. */
  readonly alphaFactor: number
  readonly rhoFactor: number
  /** The last move, opened: see QTrace. */
  readonly last: Last
}

/** Written again by every move, so that no move allocates. `move` −1: no road led away. */
interface Last {
  readonly draws: Float64Array
  from: number
  teleported: boolean
  explores: boolean
  move: number
  to: number
  reward: number
  before: number
  bestNext: number
  after: number
  alpha: number
  ends: Ending | null
}

const noMove = (): Last => ({
  ...{ draws: new Float64Array(2), from: 0, teleported: false, explores: false, move: -1, to: 0, ends: null },
  ...{ reward: 0, before: 0, bestNext: 0, after: 0, alpha: 0 },
})

/** Moves of an episode of the standard rules at most. */
export const longestEpisode = ({ stations }: QWorld) => 20 * stations

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
    ...{ station: -1, chosen: -1, chosenExplores: false, moves: 0, episodes: 0, episodeMoves: 0, goals: 0 },
    ...{ alpha: settings.alpha, rho: settings.rho },
    alphaFactor: factorOf(settings.alphaDecay),
    rhoFactor: factorOf(settings.rhoDecay),
    last: noMove(),
  }
}

/** The learner's state as plain data (running.md 2). */
export function saveLearner(learner: QLearner): QState {
  const { q, tries, station, chosen, stream } = learner
  return {
    ...{ q: [...q], tries: [...tries], stream: [...stream], ...countsOf(learner) },
    station: station < 0 ? null : station,
    chosen: chosen < 0 ? null : chosen,
  }
}

/** Goes on from a saved state. @throws RangeError where it does not fit this world */
export function restoreLearner(learner: QLearner, state: QState): void {
  const { length } = learner.q
  if (state.q.length !== length || state.tries.length !== length)
    throw new RangeError(`This state knows ${state.q.length} moves, the map has ${length}.`)
  if (state.q.some((value) => !Number.isFinite(value))) throw new RangeError('A value is not a number.')
  if ((state.station ?? 0) >= learner.world.stations || (state.chosen ?? 0) >= Math.max(1, length))
    throw new RangeError('This state stands on a station that is not there.')
  learner.q.set(state.q)
  learner.tries.set(state.tries)
  learner.stream.set(state.stream)
  learner.station = state.station ?? -1
  learner.chosen = state.chosen ?? -1
  Object.assign(learner, countsOf(state))
}

type Count = 'chosenExplores' | 'moves' | 'episodes' | 'episodeMoves' | 'goals' | 'alpha' | 'rho'
const countsOf = (from: Pick<QState, Count>): Pick<QState, Count> => {
  const { chosenExplores, moves, episodes, episodeMoves, goals, alpha, rho } = from
  return { chosenExplores, moves, episodes, episodeMoves, goals, alpha, rho }
}

const factorOf = (decay: Decay | undefined) => (decay?.kind === 'episodes' ? decay.factor : 1)
