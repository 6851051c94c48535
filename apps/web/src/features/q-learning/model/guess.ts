import type { QWorld } from '@botgarten/learning/q-learning'
import type { LearningOutline } from '@botgarten/programs'
import { movesFrom } from './shown.ts'

/** Identifies the question of a guess; a guess for another key is void. */
export const taskKey = ({ map, start, goal, closed }: LearningOutline): string =>
  JSON.stringify([map, start, goal, closed])

/** A way that a child has tapped, station by station, from the start on. */
export type Guess = readonly number[]

export const reachesGoal = ({ goal }: Pick<QWorld, 'goal'>, guess: Guess): boolean =>
  guess.length > 1 && guess.at(-1) === goal

/** Where an open road leads from the last station: to one that is not on the way yet. None from the goal. */
export function nextStations(world: QWorld, guess: Guess): readonly number[] {
  if (reachesGoal(world, guess)) return []
  const all = [...movesFrom(world, guess.at(-1) ?? world.start).keys()]
  return all.filter((station) => !guess.includes(station))
}

/** The guess after a tap on a station: on a neighbour it goes on, on its own end it goes back, elsewhere it stays. */
export function tapped(world: QWorld, guess: Guess, station: number): Guess {
  if (nextStations(world, guess).includes(station)) return [...guess, station]
  return guess.length > 1 && guess.at(-1) === station ? guess.slice(0, -1) : guess
}

export interface Comparison {
  /** Roads that the guess has more than the learned way; negative: fewer. */
  readonly more: number
  /** Where both part: the first station at which they go different ways; null: they are the same. */
  readonly parting: number | null
  /** The stations of their common end, where it has a road at least; else empty. */
  readonly common: readonly number[]
}

export function compare(guess: Guess, way: readonly number[]): Comparison {
  const parts = guess.findIndex((station, at) => station !== way[at])
  let shared = 0
  while (shared < Math.min(guess.length, way.length) && guess.at(-1 - shared) === way.at(-1 - shared))
    shared += 1
  return {
    more: guess.length - way.length,
    parting: parts < 0 ? null : (guess[parts - 1] ?? null),
    common: parts < 0 || shared < 2 ? [] : guess.slice(-shared),
  }
}
