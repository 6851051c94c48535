import { heldFor, numberOf, tooShort, type Kind } from './kind.ts'
import { readingOf, speedIn } from './moment.ts'

interface Memory {
  held: number
  longest: number
  /** What the sensor read last, and the last speed, in percent. */
  light: number | null
  speed: number
  done: boolean
}

/** The robot stands (slower than `percent`) where its light sensor reads less than `light` for `seconds`; it stays passed. */
export const rests: Kind<Memory> = {
  needs: ['light', 'percent'],
  lacks: ['bright', 'moving', 'short'],
  begin: () => ({ held: 0, longest: 0, light: null, speed: 0, done: false }),
  observe(check, moment, memory) {
    const light = readingOf(moment, 'colour', 'light')
    memory.light = typeof light === 'number' ? light : null
    memory.speed = speedIn(moment)
    const dark = memory.light !== null && memory.light < numberOf(check, 'light')
    memory.done = heldFor(check, memory, dark && memory.speed < numberOf(check, 'percent')) || memory.done
    return memory.done
  },
  missing(check, { light, speed, longest }) {
    if (light === null || light >= numberOf(check, 'light'))
      return { what: 'bright', facts: { light: light ?? 100 } }
    if (speed >= numberOf(check, 'percent')) return { what: 'moving', facts: { speed } }
    return tooShort(check, longest)
  },
}
