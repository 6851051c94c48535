import { numberOf, type Kind } from './kind.ts'
import { readingOf, robotIn } from './moment.ts'

/**
 * The robot has sounded one tone where its distance sensor reads at most `near` cm and another one where it reads at least
 * `far` cm, and the two are at least `hertz` apart; it stays passed.
 */
export const sings: Kind<{ near: number | null; far: number | null; done: boolean }> = {
  needs: ['near', 'far', 'hertz'],
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
}
