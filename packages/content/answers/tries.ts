import { courseOf, type MapFile } from '@botgarten/maps'
import { learnedPath, run, shortestPath } from '@botgarten/learning/q-learning'
import type { LearningOutline } from '@botgarten/programs'

/** A row of the table of an answer: what a learner has after so many tries. */
export interface TriesRow {
  readonly tries: number
  /** Seconds that the dice of seed 1 take, a move a second. */
  readonly seconds: number
  /** The fewest and the most that the dice of seeds 1 to 5 take. */
  readonly range: readonly [number, number]
  /** The way of seed 1; null: there is none yet. */
  readonly way: readonly number[] | null
  /** How many of 100 learners (seeds 1 to 100) know a shortest way. */
  readonly shortest: number
}

const dice = 5
const bos = 100
/** No way is so long: only the number of tries ends a learning. */
const steps = 10_000_000

/** What the learner of a card comes to, by the number of its tries. Seeds are those of the lab and of `botgarten learn q`. */
export function triesOf(
  outline: LearningOutline,
  map: MapFile,
  tries: readonly number[],
): readonly TriesRow[] {
  return tries.map((episodes) => {
    const learned = Array.from({ length: bos }, (_, at) => learn(outline, map, at + 1, episodes))
    const some = learned.slice(0, dice).map(({ seconds }) => seconds)
    return {
      tries: episodes,
      seconds: learned[0]!.seconds,
      range: [Math.min(...some), Math.max(...some)],
      way: learned[0]!.way,
      shortest: learned.filter(({ isShortest }) => isShortest).length,
    }
  })
}

function learn(outline: LearningOutline, map: MapFile, seed: number, episodes: number) {
  const { learner } = courseOf(outline, map, seed)
  run(learner, steps, episodes)
  const way = learnedPath(learner).states
  return {
    ...{ way, seconds: learner.steps },
    isShortest: way?.length === shortestPath(learner.world),
  }
}
