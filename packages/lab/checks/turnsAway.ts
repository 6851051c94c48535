import { heldFor, nameOf, numberOf, type Kind } from './kind.ts'
import { gapIn } from './moment.ts'

/** After it has come within `near` cm of the obstacle, the robot keeps at least `far` cm away for `seconds`. */
export const turnsAway: Kind<{ came: boolean; held: number; done: boolean }> = {
  needs: ['obstacle', 'near', 'far'],
  begin: () => ({ came: false, held: 0, done: false }),
  observe(check, moment, memory) {
    const gap = gapIn(moment, nameOf(check, 'obstacle'))
    if (gap === null) return false
    memory.came ||= gap <= numberOf(check, 'near')
    memory.done = heldFor(check, memory, memory.came && gap >= numberOf(check, 'far')) || memory.done
    return memory.done
  },
}
