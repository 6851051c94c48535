import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { content } from '@botgarten/content/files'
import { beginNight, tableOf } from '@botgarten/lab/trying'
import { tryingIn } from '@botgarten/programs'
import { afterEach, beforeAll, expect, test, vi } from 'vitest'
import { paintFloor } from '@botgarten/simulation'
import { proofOf } from './proof.ts'

beforeAll(() => addBlocks(learning))
afterEach(() => vi.restoreAllMocks())

function learnedFor(ticks: number) {
  const { trial } = tryingIn(content.program('try-dodge', 'solution')!.programs['main']!)!
  const world = content.world('garden')!
  const floor = paintFloor(world)
  const night = beginNight(world, floor, trial)
  night.advance(ticks)
  return { world, floor, robot: 0, table: tableOf(night.state) }
}

interface Data {
  readonly gamma: number
  readonly first: readonly number[]
  readonly q: readonly number[]
  readonly steps: readonly (readonly [number, number, number, number, number, number])[]
}

test('every move that led to a value is in its proof: the textbook update over them makes it again', async () => {
  const learned = learnedFor(3600)
  const cell = learned.table.tries.indexOf(Math.max(...learned.table.tries))
  const proof = (await proofOf(learned, cell))!
  const { gamma, first, q, steps } = proof.data as unknown as Data
  expect(steps).toHaveLength(240)
  const values = [...q]
  for (const [, action, reward, after, , alpha] of steps) {
    const best = after < 0 ? 0 : Math.max(...values.slice(first[after], first[after + 1]))
    values[action] = (1 - alpha) * values[action]! + alpha * (reward + gamma * best)
  }
  expect(values[cell]).toBe(proof.number)
  expect(proof.number).toBe(learned.table.q[cell])
})

test('while a proof is made, the page gets its turn after every 600 ticks', async () => {
  const learned = learnedFor(3600)
  const turns = vi.spyOn(globalThis, 'setTimeout')
  await proofOf(learned, 0)
  expect(turns).toHaveBeenCalledTimes(3600 / 600)
})

test('a table that came about in another way has none', async () => {
  const { table, ...rest } = learnedFor(600)
  const other = { ...table, q: table.q.map((value) => value + 1) }
  expect(await proofOf({ ...rest, table: other }, 0)).toBeNull()
})
