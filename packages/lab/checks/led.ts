import { heldFor, nameOf, type Kind } from './kind.ts'
import { colourUnder, robotIn } from './moment.ts'

/**
 * While the robot's colour sensor sees `colour` (one of the eight, `#RRGGBB`), its lamp shines in `lamp` (green, orange
 * or red; '' is dark) for `seconds` without a break; it stays passed.
 */
export const led: Kind<{ held: number; done: boolean }> = {
  needs: ['colour', 'lamp'],
  begin: () => ({ held: 0, done: false }),
  observe(check, moment, memory) {
    const shines = (robotIn(moment).led ?? '') === nameOf(check, 'lamp')
    const holds = shines && colourUnder(moment) === nameOf(check, 'colour')
    memory.done = heldFor(check, memory, holds) || memory.done
    return memory.done
  },
}
