import type { Check } from '../types.ts'
import { nameOf, numberOf, type Kind } from './kind.ts'
import { awayFrom, colourUnder, robotIn, speedIn, type Moment } from './moment.ts'

interface Memory {
  next: number | null
  passed: number
  /** Has a wheel turned in this run? */
  drove: boolean
  /**
   * The robot drove and stands now, on an edge between two colours where its sensor names neither: inputs that wait for a
   * colour are all 0 there.
   */
  blind: boolean
}

/**
 * The middle of the robot's axle has come within `cm` of every gate of `gates` ("x y, x y, …") in this order, `laps` times
 * over, from the gate after the one where the run began; it stays passed.
 */
export const laps: Kind<Memory> = {
  needs: ['gates', 'cm', 'laps'],
  lacks: ['some', 'blind'],
  begin: () => ({ next: null, passed: 0, drove: false, blind: false }),
  observe(check, moment, memory) {
    const away = gatesOf(check).map(([x, y]) => awayFrom(moment, x, y))
    memory.next ??= nextGate(away)
    memory.drove ||= speedIn(moment) > 0
    memory.blind = memory.drove && speedIn(moment) === 0 && colourUnder(moment) === ''
    const all = away.length * numberOf(check, 'laps')
    if (memory.passed < all && away[memory.next]! <= numberOf(check, 'cm')) {
      memory.passed += 1
      memory.next = (memory.next + 1) % away.length
    }
    return memory.passed === all
  },
  missing(check, { passed, next, blind }, moment) {
    const gates = gatesOf(check)
    const [x, y] = gates[next ?? nextGate(gates.map(([x, y]) => awayFrom(moment, x, y)))]!
    const all = gates.length * numberOf(check, 'laps')
    return {
      what: blind ? 'blind' : 'some',
      facts: { passed, all },
      gap: { from: placeOf(moment), to: { x, y } },
    }
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
