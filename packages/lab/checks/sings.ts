import type { Lack } from '../types.ts'
import { numberOf, type Kind } from './kind.ts'
import { readingOf, robotIn } from './moment.ts'

/**
 * The robot has sounded one tone where its distance sensor reads at most `near` cm and another one where it reads at least
 * `far` cm, and the two are at least `hertz` apart; it stays passed.
 */
export const sings: Kind<{ near: number | null; far: number | null; done: boolean }> = {
  needs: ['near', 'far', 'hertz'],
  lacks: ['silent', 'near', 'far', 'alike'],
  begin: () => ({ near: null, far: null, done: false }),
  observe(check, moment, memory) {
    const away = readingOf(moment, 'ultrasonic', 'distance')
    const tone = robotIn(moment).tone
    if (typeof away !== 'number' || !tone) return memory.done
    if (away <= numberOf(check, 'near')) memory.near = tone.frequency
    if (away >= numberOf(check, 'far')) memory.far = tone.frequency
    const { near, far } = memory
    memory.done ||= near !== null && far !== null && Math.abs(near - far) >= numberOf(check, 'hertz')
    return memory.done
  },
  missing(check, { near, far }): Lack {
    if (near === null && far === null) return { what: 'silent', facts: {} }
    if (near === null) return { what: 'near', facts: { most: numberOf(check, 'near') } }
    if (far === null) return { what: 'far', facts: { least: numberOf(check, 'far') } }
    return { what: 'alike', facts: { hertz: Math.abs(near - far), needed: numberOf(check, 'hertz') } }
  },
}
