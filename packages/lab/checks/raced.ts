import type { Lack } from '../types.ts'
import { numberOf, type Kind } from './kind.ts'

/** In the project's last race of brains at least so many `brains` drove to its end. */
export const raced: Kind<object> = {
  needs: ['brains'],
  lacks: ['not', 'few'],
  begin: () => ({}),
  observe: (check, { raced }) => (raced?.brains ?? 0) >= numberOf(check, 'brains'),
  missing: (check, _memory, { raced }): Lack =>
    raced
      ? { what: 'few', facts: { seen: raced.brains, needed: numberOf(check, 'brains') } }
      : { what: 'not', facts: {} },
}
