import { nameOf, type Kind } from './kind.ts'
import { colourUnder } from './moment.ts'

/** The robot has driven for `seconds`, and its colour sensor has never seen `colour`; counts until the check `until` has passed. */
export const neverSees: Kind<{ saw: boolean }> = {
  needs: ['colour', 'until'],
  begin: () => ({ saw: false }),
  observe(check, moment, memory) {
    const counts = !moment.passed(nameOf(check, 'until'))
    memory.saw ||= counts && colourUnder(moment) === nameOf(check, 'colour')
    return !memory.saw && moment.seconds >= check.seconds
  },
}
