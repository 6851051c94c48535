import type { Episode } from '@botgarten/learning/q-learning'

/** More than these are not told apart. */
const MOST = 20

/** The end of a try on the timeline. */
export interface Tick {
  /** Counted from 1. */
  readonly episode: number
  /** 0..1 of all moves. */
  readonly at: number
}

/** Where tries ended: each of them, or every second, fifth, tenth, so that there are at most twenty. */
export function ticksOf(episodes: readonly Pick<Episode, 'end'>[], made: number): readonly Tick[] {
  const step = stepFor(episodes.length)
  const count = Math.floor(episodes.length / step)
  return Array.from({ length: count }, (_, index) => {
    const episode = (index + 1) * step
    return { episode, at: episodes[episode - 1]!.end / Math.max(1, made) }
  })
}

/** 1, 2, 5, 10, 20, 50, … */
function stepFor(count: number): number {
  for (let ten = 1; ; ten *= 10)
    for (const step of [ten, 2 * ten, 5 * ten]) if (count <= MOST * step) return step
}
