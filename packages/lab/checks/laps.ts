import type { Check } from '../types.ts'
import { nameOf, numberOf, type Kind } from './kind.ts'
import { awayFrom, robotIn, type Moment } from './moment.ts'

/**
 * The middle of the robot's axle has come within `cm` of every gate of `gates` ("x y, x y, …") in this order, `laps` times
 * over, from the gate after the one where the run began; it stays passed.
 */
export const laps: Kind<{ next: number | null; passed: number }> = {
  needs: ['gates', 'cm', 'laps'],
  lacks: ['some'],
  begin: () => ({ next: null, passed: 0 }),
  observe(check, moment, memory) {
    const away = gatesOf(check).map(([x, y]) => awayFrom(moment, x, y))
    memory.next ??= nextGate(away)
    const all = away.length * numberOf(check, 'laps')
    if (memory.passed < all && away[memory.next]! <= numberOf(check, 'cm')) {
      memory.passed += 1
      memory.next = (memory.next + 1) % away.length
    }
    return memory.passed === all
  },
  missing(check, { passed, next }, moment) {
    const gates = gatesOf(check)
    const [x, y] = gates[next ?? nextGate(gates.map(([x, y]) => awayFrom(moment, x, y)))]!
    const all = gates.length * numberOf(check, 'laps')
    return { what: 'some', facts: { passed, all }, gap: { from: placeOf(moment), to: { x, y } } }
  },
}

const gatesOf = (check: Check): readonly (readonly [x: number, y: number])[] =>
  nameOf(check, 'gates')
    .split(',')
    .map((gate) => gate.trim().split(' ').map(Number))
    .map(([x = NaN, y = NaN]) => [x, y])

/** Index of the gate after the nearest one. */
const nextGate = (away: readonly number[]) => (away.indexOf(Math.min(...away)) + 1) % away.length

function placeOf(moment: Moment) {
  const { x, y } = robotIn(moment)
  return { x, y }
}
