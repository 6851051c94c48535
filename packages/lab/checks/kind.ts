import { TICKS_PER_SECOND } from '@botgarten/simulation'
import type { Check, Lack } from '../types.ts'
import type { Moment } from './moment.ts'

/** One kind of check, one file. `memory` is plain data that the kind keeps from tick to tick. */
export interface Kind<Memory extends object> {
  /** Names that `numbers` must hold; the card's contract test asks for them. */
  readonly needs: readonly string[]
  /** Every way to miss it; a sentence each for the screen. */
  readonly lacks: readonly string[]
  begin(): Memory
  /** One tick: has the robot done it? Writes into `memory`. */
  observe(check: Check, moment: Moment, memory: Memory): boolean
  /** What a run that is over has missed, measured. `moment`: where the run ended. */
  missing(check: Check, memory: Memory, moment: Moment): Lack
}

/** A kind among others: what it remembers is its own business. */
export interface AnyKind {
  readonly needs: readonly string[]
  readonly lacks: readonly string[]
  begin(): object
  observe(check: Check, moment: Moment, memory: never): boolean
  missing(check: Check, memory: never, moment: Moment): Lack
}

export const numberOf = (check: Check, name: string): number => Number(check.numbers[name])
export const nameOf = (check: Check, name: string): string => String(check.numbers[name])

/** Has something held for the check's seconds without a break? `longest`: ticks of the longest stretch so far. */
export function heldFor(check: Check, memory: Held, holds: boolean): boolean {
  memory.held = holds ? memory.held + 1 : 0
  if (memory.longest !== undefined) memory.longest = Math.max(memory.longest, memory.held)
  return memory.held >= check.seconds * TICKS_PER_SECOND
}

interface Held {
  held: number
  longest?: number
}

/** It was right, and not for long enough. */
export const tooShort = (check: Check, ticks: number, facts: Lack['facts'] = {}): Lack => ({
  what: 'short',
  facts: { ...facts, seconds: ticks / TICKS_PER_SECOND, needed: check.seconds },
})
