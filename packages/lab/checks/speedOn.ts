import { heldFor, nameOf, numberOf, type Kind } from './kind.ts'
import { colourUnder, speedIn } from './moment.ts'

/**
 * While the robot's colour sensor sees `colour`, the mean speed of its wheels is at least `least` and at most `most`
 * percent for `seconds` without a break; it stays passed.
 */
export const speedOn: Kind<{ held: number; done: boolean }> = {
  needs: ['colour', 'least', 'most'],
  begin: () => ({ held: 0, done: false }),
  observe(check, moment, memory) {
    const speed = speedIn(moment)
    const fits = speed >= numberOf(check, 'least') && speed <= numberOf(check, 'most')
    const holds = fits && colourUnder(moment) === nameOf(check, 'colour')
    memory.done = heldFor(check, memory, holds) || memory.done
    return memory.done
  },
}
