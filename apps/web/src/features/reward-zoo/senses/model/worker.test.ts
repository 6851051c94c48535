import { content } from '@botgarten/content/files'
import { shownIn } from '@botgarten/experiments/cages'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { workersHere } from '#lab/testing/worker.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import type { Order, Report } from './messages.ts'
import { newWorker } from './new-worker.ts'
import { SenseWork } from './sense-work.svelte.ts'

let workers: ReturnType<typeof workersHere>
let work: SenseWork
/** One whose sensors need no picture of the floor. */
const loaded = content.senseCages.find(({ cage }) =>
  cage.trial.sensors.every(({ mode }) => mode === 'distance' || mode === 'touch'),
)!
beforeEach(() => {
  freshLocalStorage()
  screen()
  workers = workersHere(() => import('./worker.ts'))
  const world = content.world(loaded.cage.world)!
  const worlds = loaded.cage.starts.map((pose) => ({ ...world, robots: [{ ...world.robots[0]!, pose }] }))
  work = new SenseWork(loaded, { worlds, picture: null })
})
afterEach(() => {
  work.close()
  vi.unstubAllGlobals()
})

test('the robot of the cage drives from every start, by the table that it has learned', async () => {
  work.guessThat('cheats')
  work.watch()
  await vi.waitFor(() => expect(work.busy).toBe(false), { timeout: 30_000 })
  expect(work.failed).toBe(false)
  const { watched, table, minute } = work.seen!
  expect([watched.length, minute]).toEqual([loaded.cage.starts.length, null])
  expect(table).toEqual(structuredClone(shownIn(loaded.cage, loaded.rows)))
  for (const [at, { poses, coins, posesAMove }] of watched.entries()) {
    const { x, y } = loaded.cage.starts[at]!
    expect([Math.round(poses[0]!.x), Math.round(poses[0]!.y)]).toEqual([Math.round(x), Math.round(y)])
    expect(poses.length).toBeGreaterThanOrEqual(coins.length * posesAMove)
  }
  expect([work.player.playing, work.isCagePay]).toEqual([true, true])
  work.close()
  expect(workers.map(({ isOver }) => isOver)).toEqual([true])
})

test('the robot of the cage learns with another pay, and drives by what it has learned', async () => {
  const { cage } = loaded
  const pay = [{ for: 'bump', coins: -7 }] as const
  const reports: Report[] = []
  const worker = newWorker()
  worker.onmessage = ({ data }: MessageEvent<Report>) => void reports.push(data)
  const order = (one: Order) => worker.postMessage(one)
  order({ kind: 'open', cage, grounds: work.grounds })
  order({ kind: 'learn', pay, seed: 5 })
  await vi.waitFor(() => expect(reports.at(-1)?.kind).toBe('seen'), { timeout: 30_000 })
  worker.terminate()
  const { seen } = reports.at(-1) as Extract<Report, { kind: 'seen' }>
  expect([seen.table.pay, seen.table.seed]).toEqual([pay, 5])
  expect(seen.table.moves).toBeGreaterThan(0)
  expect(seen.watched).toHaveLength(cage.starts.length)
})
