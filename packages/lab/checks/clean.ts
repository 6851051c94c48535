import { place } from '@botgarten/learning/neural-network/examples'
import type { Check, Lack } from '../types.ts'
import { nameOf, numberOf, type Kind } from './kind.ts'
import type { Moment } from './moment.ts'
import { drivesWhere, isIn, isOn, rowsIn } from './taught.ts'

/**
 * Of the `rows` examples that came with the drive `drive`, at least `found` of the wrong ones are off or gone, and at most
 * `goodLost` of the others. `wrong`: their ticks, "3,9,…".
 */
export const clean: Kind<object> = {
  needs: ['drive', 'rows', 'wrong', 'found', 'goodLost'],
  lacks: ['wrong', 'lost'],
  begin: () => ({}),
  observe(check, moment) {
    const { found, lost } = counted(check, moment)
    return found >= numberOf(check, 'found') && lost <= numberOf(check, 'goodLost')
  },
  missing(check, _memory, moment): Lack {
    const { found, lost } = counted(check, moment)
    const needed = numberOf(check, 'found')
    if (found < needed) return { what: 'wrong', facts: { seen: found, needed } }
    return { what: 'lost', facts: { seen: lost, most: numberOf(check, 'goodLost') } }
  },
}

function counted(check: Check, moment: Moment) {
  const wrong = new Set(nameOf(check, 'wrong').split(',').map(Number))
  const given = drivesWhere(moment, ({ id }) => id === nameOf(check, 'drive'))
  const left = rowsIn(moment).filter((row) => isOn(row) && isIn(given, row))
  const wrongLeft = left.filter((row) => wrong.has(row[place.tick]!)).length
  const good = numberOf(check, 'rows') - wrong.size
  return { found: wrong.size - wrongLeft, lost: good - (left.length - wrongLeft) }
}
