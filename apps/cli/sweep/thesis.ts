import type { Command } from '../commands.ts'
import { seedOf } from '../learn-options.ts'
import { findMap } from '../maps.ts'
import { options, refuseMore, wholeNumberIn } from '../options.ts'
import { settingsIn } from './grid.ts'
import type { Job } from './runs.ts'
import { threadsIn } from './sweep.ts'
import { csvOf, handOut, pieceOf, shardIn, tableOptions, tell } from './table.ts'
import { rowsOf } from './threads.ts'

/** The thesis's tuning grid (spec/q-learning-playground.md, "Without a screen"). */
const lists = {
  alpha: '.01,.3,.5,.7,.99',
  gamma: '.02,.2,.5,.7,.99',
  nu: '.01,.5,.99',
  rho: '.01,.5,.99',
}

/** The card's task of each map, and how many moves a run has. */
const tasks = [
  {
    map: 'railway',
    start: 3,
    goal: 1,
    closed: [
      [3, 2],
      [2, 3],
    ],
    moves: 100,
  },
  { map: 'forest', start: 0, goal: 7, closed: [[4, 6]], moves: 50 },
  { map: 'city', start: 0, goal: 15, closed: [[16, 15]], moves: 500 },
] as const

const known = { ...tableOptions, seed: { type: 'string' } } as const

/** `botgarten learn q-thesis …`: 225 settings, 50 runs each, on three maps, by the study rules. */
export const thesis: Command = { options: known, carryOut: sweepThesis }

async function sweepThesis(args: string[]): Promise<string> {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  const runs = wholeNumberIn('runs', values.runs, 50, 1, 1_000_000)
  const all = tasks.flatMap(({ map, start, goal, closed, moves }) => {
    const task = { map: findMap(map).map, start, goal, closed }
    const job: Job = {
      task,
      rules: 'study',
      algorithm: 'q',
      moves,
      episodes: moves,
      runs,
      seed: seedOf(values),
    }
    return settingsIn(lists).map((setting) => ({ map, job, setting }))
  })
  const shard = shardIn(values.shard)
  const mine = pieceOf(all, shard)
  const rows = await rowsOf(mine, threadsIn(values.threads), (count) => tell(count, mine.length))
  const named = rows.map((row, index) => ({ map: mine[index]!.map, ...row }))
  if (values.json) return JSON.stringify(named)
  return handOut(csvOf(named, shard, true), values.csv, rows.length)
}
