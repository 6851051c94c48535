import type { PracticeNote } from '@botgarten/learning/neural-network/brain'
import { percentOff } from '@botgarten/learning/neural-network/train'
import { numberOf, type Kind } from './kind.ts'
import type { Lack } from '../types.ts'

/** It has practised with a learning rate of at least `rate` and ended at most `percent` off what it practised. */
export const settled: Kind<object> = {
  needs: ['rate', 'percent'],
  lacks: ['unpractised', 'slow', 'off'],
  begin: () => ({}),
  observe(check, { taught }) {
    const note = taught?.practice
    if (!note || note.round === 0) return false
    return note.settings.rate >= numberOf(check, 'rate') && errorOf(note) <= numberOf(check, 'percent')
  },
  missing(check, _memory, { taught }): Lack {
    const note = taught?.practice
    if (!note || note.round === 0) return { what: 'unpractised', facts: {} }
    if (note.settings.rate < numberOf(check, 'rate')) return { what: 'slow', facts: {} }
    return { what: 'off', facts: { off: errorOf(note), most: numberOf(check, 'percent') } }
  },
}

/** How far off it was with the weights that it ended with, in percent. */
function errorOf({ curve, round }: PracticeNote): number {
  const last = curve.findLast((point) => point.round === round)
  return last ? percentOff(last.practised) : Infinity
}
