import { nameOf, type Kind } from './kind.ts'
import { robotIn } from './moment.ts'

/**
 * The robot has driven for `seconds` without touching the obstacle. Counts until the check `until` has passed:
 * a robot that creeps on after its task is done has still done it.
 */
export const neverTouches: Kind<{ touched: boolean }> = {
  needs: ['obstacle', 'until'],
  begin: () => ({ touched: false }),
  observe(check, moment, memory) {
    const counts = !moment.passed(nameOf(check, 'until'))
    memory.touched ||= counts && robotIn(moment).touching.includes(nameOf(check, 'obstacle'))
    return !memory.touched && moment.seconds >= check.seconds
  },
}
