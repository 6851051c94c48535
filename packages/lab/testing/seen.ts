import type { Simulation } from '@botgarten/simulation'
import type { Seen } from '../checks/seen.ts'

/** The input of checks for a simulation alone: nothing was taught, tried or raced, and no program sets a wheel. */
export const seenBy = (
  { world, state, read }: Pick<Simulation, 'world' | 'state' | 'read'>,
  more: Partial<Seen> = {},
): Seen => ({
  ...{ world, state, read, nextTurn: () => null, taught: null, trying: false },
  ...{ table: null, raced: null, closed: [] },
  ...more,
})
