import { heldFor, nameOf, numberOf, tooShort, type Kind } from './kind.ts'
import { frontOf, gapIn, gapTo, speedIn } from './moment.ts'

/** After so many still ticks a twitch is forgotten. */
const calm = 15
/** A second twitch before that is driving. */
const driving = 1.5

/** `stir`: a moving tick counts 1, and fades while it is still. `moved`: did it drive, in the last tick that was looked at? */
interface Memory {
  held: number
  longest: number
  stir: number
  moved: boolean
}

/**
 * The robot stands (slower than `percent`) within `cm` of the obstacle for `seconds`; "quite still" is never reached. A twitch
 * of one tick now and then stands to the eye: a sensor that errs lets a rule jump at its limit.
 */
export const stays: Kind<Memory> = {
  needs: ['obstacle', 'cm', 'percent'],
  lacks: ['far', 'moving', 'short'],
  begin: () => ({ held: 0, longest: 0, stir: 0, moved: false }),
  observe(check, moment, memory) {
    const gap = gapIn(moment, nameOf(check, 'obstacle'))
    const close = gap !== null && gap <= numberOf(check, 'cm')
    const stirs = speedIn(moment) >= numberOf(check, 'percent')
    memory.stir = stirs ? Math.min(2, memory.stir + 1) : Math.max(0, memory.stir - 1 / calm)
    memory.moved = stirs && memory.stir > driving
    return heldFor(check, memory, close && !memory.moved)
  },
  missing(check, { moved, longest }, moment) {
    const thing = nameOf(check, 'obstacle')
    const [away, to] = [gapIn(moment, thing) ?? 0, gapTo(moment, thing)]
    if (away > numberOf(check, 'cm'))
      return { what: 'far', facts: { thing, away }, ...(to && { gap: { from: frontOf(moment), to } }) }
    return moved ? { what: 'moving', facts: { thing } } : tooShort(check, longest)
  },
}
