import { TICKS_PER_SECOND } from '@botgarten/simulation'
import type { Check } from '../types.ts'
import type { Moment } from './moment.ts'

/** One kind of check, one file. `memory` is plain data that the kind keeps from tick to tick. */
export interface Kind<Memory extends object> {
  /** Names that `numbers` must hold; the card's contract test asks for them. */
  readonly needs: readonly string[]
  begin(): Memory
  /** One tick: has the robot done it? Writes into `memory`. */
  observe(check: Check, moment: Moment, memory: Memory): boolean
}

/** A kind among others: what it remembers is its own business. */
export interface AnyKind {
  readonly needs: readonly string[]
  begin(): object
  observe(check: Check, moment: Moment, memory: never): boolean
}

export const numberOf = (check: Check, name: string): number => Number(check.numbers[name])
export const nameOf = (check: Check, name: string): string => String(check.numbers[name])

/** Has something held for the check's seconds without a break? */
export function heldFor(check: Check, memory: { held: number }, holds: boolean): boolean {
  memory.held = holds ? memory.held + 1 : 0
  return memory.held >= check.seconds * TICKS_PER_SECOND
}
