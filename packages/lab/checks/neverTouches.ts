import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { nameOf, tooShort, type Kind } from './kind.ts'
import { robotIn } from './moment.ts'

/**
 * The robot has driven for `seconds` without touching the obstacle. Counts until the check `until` has passed:
 * a robot that creeps on after its task is done has still done it.
 */
export const neverTouches: Kind<{ touched: boolean; at: number }> = {
  needs: ['obstacle', 'until'],
  lacks: ['touched', 'short'],
  begin: () => ({ touched: false, at: 0 }),
  observe(check, moment, memory) {
    const counts = !moment.passed(nameOf(check, 'until'))
    const touches = counts && robotIn(moment).touching.includes(nameOf(check, 'obstacle'))
    if (touches && !memory.touched) memory.at = moment.seconds
    memory.touched ||= touches
    return !memory.touched && moment.seconds >= check.seconds
  },
  missing(check, { touched, at }, { seconds }) {
    const thing = nameOf(check, 'obstacle')
    if (touched) return { what: 'touched', facts: { thing, seconds: at }, broken: true }
    return tooShort(check, seconds * TICKS_PER_SECOND)
  },
}
