import type { Block, Frame } from '../types.ts'
import { field } from './fields.ts'
import { choice, worded } from './looks.ts'
import { numberAt, percent } from './numbers.ts'

/** Open Roberta spells "backward" with an s where a distance follows, and FOREWARD everywhere. */
export const direction = (backward: 'BACKWARD' | 'BACKWARDS') =>
  choice('DIRECTION', [worded('FOREWARD', 'forward'), worded(backward, 'backward')])

export const side = choice('DIRECTION', [worded('RIGHT', 'right'), worded('LEFT', 'left')])

const secondWays = new Set(['BACKWARD', 'BACKWARDS', 'LEFT'])

/** The first value as percent, negative where the field names the second way (backward, left). Never −0. */
export function speedOf(frame: Frame, block: Block): number {
  const speed = percent(numberAt(frame, 0))
  return secondWays.has(field(block, 'DIRECTION')) ? 0 - speed : speed
}

/** The first two values as percent of the wheels, negative where the field says backward. Never −0. */
export function speedsOf(frame: Frame, block: Block): { readonly left: number; readonly right: number } {
  const sign = secondWays.has(field(block, 'DIRECTION')) ? -1 : 1
  return { left: percent(numberAt(frame, 0)) * sign + 0, right: percent(numberAt(frame, 1)) * sign + 0 }
}
