import { sayable } from '../sayable.ts'
import { headingOf } from '../sides.ts'
import type { Slide } from './deck.ts'

/**
 * What a voice says of a slide: what stands on it, and never what the teacher says to it. `shown`: on the whole screen, where
 * questions are asked one by one and have a voice of their own.
 */
export function saidOf({ title, words, shown: drawn }: Slide, shown = false): string {
  const left = drawn.filter((node) => !(shown && node.type === 'embed' && node.embed.kind === 'questions'))
  return sayable([headingOf(title), ...words, ...left]) ?? title
}
