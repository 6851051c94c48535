import { nameOf, numberOf, type Kind } from './kind.ts'
import { awayFrom } from './moment.ts'

/**
 * The middle of the robot's axle has come within `cm` of every gate of `gates` ("x y, x y, …") in this order, `laps` times
 * over, from the gate after the one where the run began; it stays passed.
 */
export const laps: Kind<{ next: number | null; passed: number }> = {
  needs: ['gates', 'cm', 'laps'],
  begin: () => ({ next: null, passed: 0 }),
  observe(check, moment, memory) {
    const away = nameOf(check, 'gates')
      .split(',')
      .map((gate) => gate.trim().split(' ').map(Number))
      .map(([x = NaN, y = NaN]) => awayFrom(moment, x, y))
    memory.next ??= (away.indexOf(Math.min(...away)) + 1) % away.length
    const all = away.length * numberOf(check, 'laps')
    if (memory.passed < all && away[memory.next]! <= numberOf(check, 'cm')) {
      memory.passed += 1
      memory.next = (memory.next + 1) % away.length
    }
    return memory.passed === all
  },
}
