import { heldFor, nameOf, numberOf, tooShort, type Kind } from './kind.ts'
import { colourUnder, speedIn } from './moment.ts'

interface Memory {
  held: number
  longest: number
  /** How fast it was when the colour was seen last, in percent; null while it has not been. */
  speed: number | null
  done: boolean
}

/**
 * While the robot's colour sensor sees `colour`, the mean speed of its wheels is at least `least` and at most `most`
 * percent for `seconds` without a break; it stays passed.
 */
export const speedOn: Kind<Memory> = {
  needs: ['colour', 'least', 'most'],
  lacks: ['unseen', 'slow', 'fast', 'short'],
  begin: () => ({ held: 0, longest: 0, speed: null, done: false }),
  observe(check, moment, memory) {
    const speed = speedIn(moment)
    const sees = colourUnder(moment) === nameOf(check, 'colour')
    const fits = speed >= numberOf(check, 'least') && speed <= numberOf(check, 'most')
    if (sees) memory.speed = speed
    memory.done = heldFor(check, memory, sees && fits) || memory.done
    return memory.done
  },
  missing(check, { speed, longest }) {
    const [least, most] = [numberOf(check, 'least'), numberOf(check, 'most')]
    const colour = nameOf(check, 'colour')
    if (speed === null) return { what: 'unseen', facts: { colour } }
    if (speed < least) return { what: 'slow', facts: { colour, speed, least } }
    if (speed > most) return { what: 'fast', facts: { colour, speed, most } }
    return tooShort(check, longest, { colour })
  },
}
