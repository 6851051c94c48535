import { heldFor, nameOf, tooShort, type Kind } from './kind.ts'
import { colourUnder, robotIn } from './moment.ts'

interface Memory {
  held: number
  longest: number
  /** How the lamp shone when the colour was seen last; null while it has not been. */
  shone: string | null
  done: boolean
}

/**
 * While the robot's colour sensor sees `colour` (one of the eight, `#RRGGBB`), its lamp shines in `lamp` (green, orange
 * or red; '' is dark) for `seconds` without a break; it stays passed.
 */
export const led: Kind<Memory> = {
  needs: ['colour', 'lamp'],
  lacks: ['unseen', 'dark', 'lit', 'other', 'short'],
  begin: () => ({ held: 0, longest: 0, shone: null, done: false }),
  observe(check, moment, memory) {
    const lamp = robotIn(moment).led ?? ''
    const sees = colourUnder(moment) === nameOf(check, 'colour')
    if (sees) memory.shone = lamp
    memory.done = heldFor(check, memory, sees && lamp === nameOf(check, 'lamp')) || memory.done
    return memory.done
  },
  missing(check, { shone, longest }) {
    const [colour, lamp] = [nameOf(check, 'colour'), nameOf(check, 'lamp')]
    if (shone === null) return { what: 'unseen', facts: { colour } }
    if (shone === lamp) return tooShort(check, longest, { colour })
    if (shone === '') return { what: 'dark', facts: { colour } }
    return lamp === ''
      ? { what: 'lit', facts: { colour, shone } }
      : { what: 'other', facts: { colour, shone, lamp } }
  },
}
