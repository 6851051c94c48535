import type { Course } from '@botgarten/learning/q-learning'
import { sectionsOf } from '@botgarten/maps'
import { ownText, type LearnedRun, type LearningOutline, type Pay } from '@botgarten/programs'

/** A run as a row of the table of experiments. */
export function rowOf(outline: LearningOutline, course: Course, seed: number, guess: string): LearnedRun {
  const { map, start, goal, closed, settings, pay, episodes: limitEpisodes, moves: limitMoves } = outline
  const { alpha, gamma, nu, rho, rules } = settings
  const { stations } = course.way()
  return {
    ...{ map, start, goal, alpha, gamma, nu, rho, rules, limitEpisodes, limitMoves, seed, guess },
    ...(pay && { pay: payText(pay) }),
    closed: closed.map((road) => road.join('-')).join(' '),
    ...{ episodes: course.episodes.length, moves: course.made, way: stations?.join('-') ?? '' },
    ...{ shortest: sectionsOf(course) ?? 0, found: course.foundIn() ?? 0 },
  }
}

/** `length step=1 3:10`: everything that is paid beside the goal. */
const payText = ({ length, step, own = {} }: Pay): string =>
  [length ? 'length' : '', step === undefined ? '' : `step=${step}`, ownText(own)].filter(Boolean).join(' ')
