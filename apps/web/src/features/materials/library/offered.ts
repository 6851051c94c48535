import { shelves, type Shelf } from './choice.ts'

/** What can be chosen from. */
export const offered = {
  grades: [3, 4, 5, 6, 7, 8, 9, 10, 11, 12],
  modules: [1, 2, 3, 4],
  shelves: Object.keys(shelves) as Shelf[],
  ways: ['supervised', 'reinforcement', 'unsupervised'],
  socials: ['alone', 'pairs', 'groups', 'class'],
  times: [20, 45, 90],
} as const
