import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { numberOf, tooShort, type Kind } from './kind.ts'

/**
 * The eyes decide which way the robot turns: had each seen what the other one saw, its program would have turned it the other
 * way, in both cases by `percent` between the wheels at least. For `seconds` in all; it stays passed.
 */
export const eyesDecide: Kind<{ ticks: number; done: boolean }> = {
  needs: ['percent'],
  lacks: ['alike', 'short'],
  begin: () => ({ ticks: 0, done: false }),
  observe(check, moment, memory) {
    if (memory.done) return true
    const least = numberOf(check, 'percent')
    const turn = moment.nextTurn(false) ?? 0
    if (Math.abs(turn) < least) return false
    const mirrored = moment.nextTurn(true) ?? 0
    if (Math.abs(mirrored) >= least && turn > 0 !== mirrored > 0) memory.ticks++
    memory.done = memory.ticks > 0 && memory.ticks >= check.seconds * TICKS_PER_SECOND
    return memory.done
  },
  missing: (check, { ticks }) => (ticks > 0 ? tooShort(check, ticks) : { what: 'alike', facts: {} }),
}
