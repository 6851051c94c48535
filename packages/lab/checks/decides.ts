import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { numberOf, tooShort, type Kind } from './kind.ts'
import type { Moment } from './moment.ts'

/**
 * Something decides how the robot turns: it turns by `percent` between the wheels at least, and had that been otherwise, it
 * would have turned otherwise. For `seconds` in all; it stays passed.
 * @param isOther compares the turn with the one that it would have been; `least`: `percent`
 */
const decides = (
  isOther: (moment: Moment, turn: number, least: number) => boolean,
): Kind<{ ticks: number }> => ({
  needs: ['percent'],
  lacks: ['alike', 'short'],
  begin: () => ({ ticks: 0 }),
  observe(check, moment, memory) {
    const least = numberOf(check, 'percent')
    const isDone = () => memory.ticks > 0 && memory.ticks >= check.seconds * TICKS_PER_SECOND
    if (isDone()) return true
    const turn = moment.nextTurn(false) ?? 0
    if (Math.abs(turn) >= least && isOther(moment, turn, least)) memory.ticks++
    return isDone()
  },
  missing: (check, { ticks }) => (ticks > 0 ? tooShort(check, ticks) : { what: 'alike', facts: {} }),
})

/** The eyes: had they seen the opposite sides, the robot would have turned the other way, by as much at least. */
export const eyesDecide = decides((moment, turn, least) => {
  const mirrored = moment.nextTurn(true) ?? 0
  return Math.abs(mirrored) >= least && turn > 0 !== mirrored > 0
})

/** The network: had it put out 0, the robot would have turned less or the other way, by `percent` at least. */
export const netDecides = decides(
  (moment, turn, least) => Math.abs(turn - (moment.nextTurn(false, false) ?? 0)) >= least,
)
