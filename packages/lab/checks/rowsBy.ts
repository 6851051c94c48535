import { nameOf, numberOf, type Kind } from './kind.ts'
import type { Moment } from './moment.ts'
import { drivesWhere, isIn, isOn, rowsIn } from './taught.ts'

/** At least `rows` examples that are on were shown `by` a coach, a pad, …; it names one of a drive's. */
export const rowsBy: Kind<object> = {
  needs: ['by', 'rows'],
  lacks: ['few'],
  begin: () => ({}),
  observe: (check, moment) => count(moment, nameOf(check, 'by')) >= numberOf(check, 'rows'),
  missing: (check, _memory, moment) => ({
    what: 'few',
    facts: { seen: count(moment, nameOf(check, 'by')), needed: numberOf(check, 'rows') },
  }),
}

function count(moment: Moment, who: string): number {
  const drives = drivesWhere(moment, ({ by }) => by === who)
  return rowsIn(moment).filter((row) => isOn(row) && isIn(drives, row)).length
}
