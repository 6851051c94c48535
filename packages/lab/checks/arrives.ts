import { heldFor, nameOf, numberOf, type Kind } from './kind.ts'
import { awayFrom, speedIn } from './moment.ts'

/** Slower than this is standing, in percent: what a program leaves behind when it has stopped the motors. */
const STANDING = 3

/**
 * The middle of the robot's axle stands within `cm` of the point `x`, `y` for `seconds`; it stays passed. Counts only
 * after the check `after` has passed ('' counts from the start).
 */
export const arrives: Kind<{ held: number; done: boolean }> = {
  needs: ['x', 'y', 'cm', 'after'],
  begin: () => ({ held: 0, done: false }),
  observe(check, moment, memory) {
    const after = nameOf(check, 'after')
    const counts = after === '' || moment.passed(after)
    const away = awayFrom(moment, numberOf(check, 'x'), numberOf(check, 'y'))
    const stands = counts && away <= numberOf(check, 'cm') && speedIn(moment) < STANDING
    memory.done = heldFor(check, memory, stands) || memory.done
    return memory.done
  },
}
