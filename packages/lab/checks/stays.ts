import { heldFor, nameOf, numberOf, tooShort, type Kind } from './kind.ts'
import { frontOf, gapIn, gapTo, speedIn } from './moment.ts'

/** `moved`: was it faster than that, in the last tick that was looked at? */
interface Memory {
  held: number
  longest: number
  moved: boolean
}

/** The robot stands (slower than `percent`) within `cm` of the obstacle for `seconds`; "quite still" is never reached. */
export const stays: Kind<Memory> = {
  needs: ['obstacle', 'cm', 'percent'],
  lacks: ['far', 'moving', 'short'],
  begin: () => ({ held: 0, longest: 0, moved: false }),
  observe(check, moment, memory) {
    const gap = gapIn(moment, nameOf(check, 'obstacle'))
    const close = gap !== null && gap <= numberOf(check, 'cm')
    memory.moved = speedIn(moment) >= numberOf(check, 'percent')
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
