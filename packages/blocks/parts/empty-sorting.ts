import type { SortingMemory } from '../types.ts'

/** What a program starts with: nothing collected, no groups. It brings nothing of the learner along. */
export const emptySorting = (): SortingMemory => ({ readings: [], collected: 0, centres: [], names: [] })
