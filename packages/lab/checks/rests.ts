import { heldFor, numberOf, type Kind } from './kind.ts'
import { readingOf, speedIn } from './moment.ts'

/** The robot stands (slower than `percent`) where its light sensor reads less than `light` for `seconds`; it stays passed. */
export const rests: Kind<{ held: number; done: boolean }> = {
  needs: ['light', 'percent'],
  begin: () => ({ held: 0, done: false }),
  observe(check, moment, memory) {
    const light = readingOf(moment, 'colour', 'light')
    const dark = typeof light === 'number' && light < numberOf(check, 'light')
    memory.done = heldFor(check, memory, dark && speedIn(moment) < numberOf(check, 'percent')) || memory.done
    return memory.done
  },
}
