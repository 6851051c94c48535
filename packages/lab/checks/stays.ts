import { heldFor, nameOf, numberOf, type Kind } from './kind.ts'
import { gapIn, speedIn } from './moment.ts'

/** The robot stands (slower than `percent`) within `cm` of the obstacle for `seconds`; "quite still" is never reached. */
export const stays: Kind<{ held: number }> = {
  needs: ['obstacle', 'cm', 'percent'],
  begin: () => ({ held: 0 }),
  observe(check, moment, memory) {
    const gap = gapIn(moment, nameOf(check, 'obstacle'))
    const close = gap !== null && gap <= numberOf(check, 'cm')
    return heldFor(check, memory, close && speedIn(moment) < numberOf(check, 'percent'))
  },
}
