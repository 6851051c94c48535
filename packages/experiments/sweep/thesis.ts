import type { QMap } from '@botgarten/learning/q-learning'
import type { Work } from './row.ts'
import { settingsOf } from './settings.ts'

/** The thesis's tuning grid. */
const lists = {
  alpha: [0.01, 0.3, 0.5, 0.7, 0.99],
  gamma: [0.02, 0.2, 0.5, 0.7, 0.99],
  nu: [0.01, 0.5, 0.99],
  rho: [0.01, 0.5, 0.99],
}

/** The card's task of each map, and how many moves a run has. */
const tasks = [
  {
    ...{ map: 'railway', start: 3, goal: 1, moves: 100 },
    closed: [
      [3, 2],
      [2, 3],
    ],
  },
  { map: 'forest', start: 0, goal: 7, moves: 50, closed: [[4, 6]] },
  { map: 'city', start: 0, goal: 15, moves: 500, closed: [[16, 15]] },
] as const

export interface ThesisWork extends Work {
  readonly map: string
}

/** 225 settings on three maps, by the study rules. */
export const thesisWork = (
  mapNamed: (id: string) => QMap,
  { runs, seed }: { readonly runs: number; readonly seed: number },
): ThesisWork[] =>
  tasks.flatMap(({ map, start, goal, closed, moves }) => {
    const task = { map: mapNamed(map), start, goal, closed }
    const job = { task, rules: 'study', algorithm: 'q', moves, episodes: moves, runs, seed } as const
    return settingsOf(lists).map((setting) => ({ map, job, setting }))
  })
