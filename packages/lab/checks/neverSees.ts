import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { nameOf, tooShort, type Kind } from './kind.ts'
import { colourUnder } from './moment.ts'

/** The robot has driven for `seconds`, and its colour sensor has never seen `colour`; counts until the check `until` has passed. */
export const neverSees: Kind<{ saw: boolean; at: number }> = {
  needs: ['colour', 'until'],
  lacks: ['saw', 'short'],
  begin: () => ({ saw: false, at: 0 }),
  observe(check, moment, memory) {
    const counts = !moment.passed(nameOf(check, 'until'))
    const sees = counts && colourUnder(moment) === nameOf(check, 'colour')
    if (sees && !memory.saw) memory.at = moment.seconds
    memory.saw ||= sees
    return !memory.saw && moment.seconds >= check.seconds
  },
  missing(check, { saw, at }, { seconds }) {
    const colour = nameOf(check, 'colour')
    if (saw) return { what: 'saw', facts: { colour, seconds: at }, broken: true }
    return tooShort(check, seconds * TICKS_PER_SECOND)
  },
}
