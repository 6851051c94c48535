import type { Learned } from '@botgarten/maps/zoo'
import { walkOf } from '@botgarten/maps/zoo'

/** So many moves are watched where Bo never comes to an end. */
export const MOST_MOVES = 100

interface WatchedStep {
  readonly from: number
  readonly to: number
  readonly reward: number
}

/** What Bo does with what it has learned. */
export interface Watched {
  readonly setting: number
  readonly outcome: Learned['outcome']
  /** Moves of all tries of learning. */
  readonly learnedIn: number
  readonly steps: readonly WatchedStep[]
  readonly reward: number
  /** How often it came to the goal. */
  readonly goals: number
}

export function watch({ world, moves, outcome, steps: learnedIn }: Learned, setting: number): Watched {
  const walked = walkOf(world, moves, MOST_MOVES)
  const steps = walked.slice(1).map((to, index) => {
    const from = walked[index]!
    return { from, to, reward: world.reward[actionBetween(world, from, to)]! }
  })
  return {
    ...{ setting, outcome, learnedIn, steps },
    reward: steps.reduce((sum, { reward }) => sum + reward, 0),
    goals: steps.filter(({ to }) => world.isGoal[to] === 1).length,
  }
}

const actionBetween = ({ from, meant }: Learned['world'], start: number, end: number): number =>
  from.findIndex((state, action) => state === start && meant[action] === end)
