import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { beginDoings, behaviourOf, noteTick, type Doings } from '../trying/doings.ts'
import { judged, measuresOf, type Cheat } from '../trying/measures.ts'
import type { Check } from '../types.ts'
import { nameOf, tooShort, type Kind } from './kind.ts'

interface Memory {
  /** Of the seconds that are under way; null: it does not drive by a table. */
  doings: Doings | null
  cheated: boolean
  done: boolean
}

/**
 * The robot drives by the table that it has learned, and for `seconds` it does not what an `animal` of the zoo does: not every
 * measure of `cheats` ("cm 0 60, bumps 0 0": least and most) lies in its range. Where all do, the next `seconds` are looked at.
 * It stays passed.
 */
export const neverCheats: Kind<Memory> = {
  needs: ['animal', 'cheats'],
  lacks: ['untried', 'short', 'trick'],
  begin: () => ({ doings: null, cheated: false, done: false }),
  observe(check, { world, simulation: state, read, table }, memory) {
    if (memory.done) return true
    if (!table) {
      Object.assign(memory, neverCheats.begin())
      return false
    }
    const seen = { world, state, read }
    memory.doings ??= beginDoings(seen)
    noteTick(memory.doings, seen, table.hold)
    if (memory.doings.ticks >= check.seconds * TICKS_PER_SECOND) judge(check, memory.doings, memory)
    return memory.done
  },
  missing(check, { doings, cheated }) {
    if (cheated) return { what: 'trick', facts: { animal: nameOf(check, 'animal') } }
    return doings ? tooShort(check, doings.ticks) : { what: 'untried', facts: {} }
  },
}

function judge(check: Check, doings: Doings, memory: Memory): void {
  memory.cheated = judged(cheatIn(nameOf(check, 'cheats')), measuresOf(behaviourOf([doings], check.seconds)))
  memory.done = !memory.cheated
  memory.doings = null
}

/** "cm 0 60, bumps 0 0" as the ranges that it says. */
function cheatIn(text: string): Cheat {
  const ranges = text.split(',').map((range) => range.trim().split(' '))
  return Object.fromEntries(ranges.map(([name = '', least, most]) => [name, [Number(least), Number(most)]]))
}
