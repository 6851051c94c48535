import type { Lack } from '../types.ts'
import { numberOf, type Kind } from './kind.ts'
import { isOn, rowsIn } from './taught.ts'

/** The network has practised at least `rounds` rounds with at least `rows` examples that are on. */
export const learned: Kind<object> = {
  needs: ['rows', 'rounds'],
  lacks: ['few', 'unpractised'],
  begin: () => ({}),
  observe: (check, moment) =>
    rowsIn(moment).filter(isOn).length >= numberOf(check, 'rows') &&
    (moment.taught?.practice?.round ?? 0) >= numberOf(check, 'rounds'),
  missing(check, _memory, moment): Lack {
    const [seen, needed] = [rowsIn(moment).filter(isOn).length, numberOf(check, 'rows')]
    return seen < needed ? { what: 'few', facts: { seen, needed } } : { what: 'unpractised', facts: {} }
  },
}
