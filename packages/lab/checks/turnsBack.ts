import type { Lack } from '../types.ts'
import { numberOf, type Kind } from './kind.ts'
import { readingOf } from './moment.ts'

/** The robot's distance sensor has read at most `near` cm, and after that at least `far` cm: it has turned round. It stays passed. */
export const turnsBack: Kind<{ nearest: number | null; done: boolean }> = {
  needs: ['near', 'far'],
  lacks: ['never', 'stayed'],
  begin: () => ({ nearest: null, done: false }),
  observe(check, moment, memory) {
    const away = readingOf(moment, 'ultrasonic', 'distance')
    if (typeof away !== 'number') return memory.done
    memory.nearest = Math.min(memory.nearest ?? away, away)
    memory.done ||= memory.nearest <= numberOf(check, 'near') && away >= numberOf(check, 'far')
    return memory.done
  },
  missing(check, { nearest }, moment): Lack {
    const away = nearest ?? readingOf(moment, 'ultrasonic', 'distance')
    if (typeof away !== 'number' || away > numberOf(check, 'near'))
      return { what: 'never', facts: { away: Number(away ?? 0) } }
    return { what: 'stayed', facts: {} }
  },
}
