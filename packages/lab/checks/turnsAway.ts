import { heldFor, nameOf, numberOf, tooShort, type Kind } from './kind.ts'
import { gapIn } from './moment.ts'

interface Memory {
  came: boolean
  held: number
  longest: number
  nearest: number | null
  /** How far away it was at most after it had come near. */
  farthest: number
  done: boolean
}

/** After it has come within `near` cm of the obstacle, the robot keeps at least `far` cm away for `seconds`. */
export const turnsAway: Kind<Memory> = {
  needs: ['obstacle', 'near', 'far'],
  lacks: ['never', 'stayed', 'short'],
  begin: () => ({ came: false, held: 0, longest: 0, nearest: null, farthest: 0, done: false }),
  observe(check, moment, memory) {
    const gap = gapIn(moment, nameOf(check, 'obstacle'))
    if (gap === null) return false
    memory.nearest = Math.min(memory.nearest ?? gap, gap)
    memory.came ||= gap <= numberOf(check, 'near')
    if (memory.came) memory.farthest = Math.max(memory.farthest, gap)
    memory.done = heldFor(check, memory, memory.came && gap >= numberOf(check, 'far')) || memory.done
    return memory.done
  },
  missing(check, { came, nearest, farthest, longest }) {
    const thing = nameOf(check, 'obstacle')
    if (!came) return { what: 'never', facts: { thing, away: nearest ?? 0 } }
    const least = numberOf(check, 'far')
    if (farthest < least) return { what: 'stayed', facts: { thing, away: farthest, least } }
    return tooShort(check, longest)
  },
}
