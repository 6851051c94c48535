import { heldFor, nameOf, numberOf, tooShort, type Kind } from './kind.ts'
import { frontOf, gapIn, gapTo, speedIn } from './moment.ts'

/** Ticks over which its speed is taken: what twitches for one of them stands, to the eye. */
const lag = 30

/** `speed`: its mean of late, in percent. */
interface Memory {
  held: number
  longest: number
  speed: number
}

/**
 * The robot stands (slower than `percent`, as a mean of half a second) within `cm` of the obstacle for `seconds`; "quite still"
 * is never reached, and a sensor that errs lets a rule jump at its limit.
 */
export const stays: Kind<Memory> = {
  needs: ['obstacle', 'cm', 'percent'],
  lacks: ['far', 'moving', 'short'],
  begin: () => ({ held: 0, longest: 0, speed: 0 }),
  observe(check, moment, memory) {
    const gap = gapIn(moment, nameOf(check, 'obstacle'))
    const close = gap !== null && gap <= numberOf(check, 'cm')
    memory.speed += (speedIn(moment) - memory.speed) / lag
    return heldFor(check, memory, close && memory.speed < numberOf(check, 'percent'))
  },
  missing(check, { speed, longest }, moment) {
    const thing = nameOf(check, 'obstacle')
    const [away, to] = [gapIn(moment, thing) ?? 0, gapTo(moment, thing)]
    if (away > numberOf(check, 'cm'))
      return { what: 'far', facts: { thing, away }, ...(to && { gap: { from: frontOf(moment), to } }) }
    return speed >= numberOf(check, 'percent')
      ? { what: 'moving', facts: { thing } }
      : tooShort(check, longest)
  },
}
