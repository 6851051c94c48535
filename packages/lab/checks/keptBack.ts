import { weightsOf, type Brain } from '@botgarten/learning/neural-network/brain'
import { errorOn, place } from '@botgarten/learning/neural-network/examples'
import type { Check, Lack } from '../types.ts'
import { nameOf, numberOf, type Kind } from './kind.ts'
import type { Moment } from './moment.ts'
import { drivesWhere, isIn, rowsIn } from './taught.ts'

/** On the examples of the drive `drive`, on or off, the network is at most `percent` off: the root of the mean square. */
export const keptBack: Kind<object> = {
  needs: ['drive', 'percent'],
  lacks: ['gone', 'off'],
  begin: () => ({}),
  observe: (check, moment) => (errorIn(check, moment) ?? Infinity) <= numberOf(check, 'percent'),
  missing(check, _memory, moment): Lack {
    const error = errorIn(check, moment)
    if (error === null) return { what: 'gone', facts: {} }
    return { what: 'off', facts: { off: error, most: numberOf(check, 'percent') } }
  },
}

/** By brain, which seldom changes, and drive: it is asked for in every tick. */
const measured = new WeakMap<Brain, Map<string, number | null>>()

function errorIn(check: Check, moment: Moment): number | null {
  const brain = moment.taught
  if (!brain?.examples) return null
  const known = measured.get(brain) ?? new Map<string, number | null>()
  measured.set(brain, known)
  const key = `${nameOf(check, 'drive')} ${moment.world.robots[0]!.brain}`
  if (!known.has(key)) known.set(key, measure(nameOf(check, 'drive'), brain, moment))
  return known.get(key)!
}

function measure(name: string, brain: Brain, moment: Moment): number | null {
  const drives = drivesWhere(moment, ({ id }) => id === name)
  const rows = rowsIn(moment).flatMap((row) => (isIn(drives, row) ? [row.with(place.on, 1)] : []))
  const weights = weightsOf(brain, moment.world.robots[0]!.brain)
  return errorOn(brain.layers, weights, { ...brain.examples!, rows }, null)
}
