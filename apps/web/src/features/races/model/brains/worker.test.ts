import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { finish, race } from '@botgarten/experiments/brain-race'
import { afterEach, expect, test, vi } from 'vitest'
import { workersHere } from '#lab/testing/worker.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { openCourse } from './ground.ts'
import { newWorker } from './new-worker.ts'
import type { Answered, Asked } from './worker.ts'

afterEach(() => vi.unstubAllGlobals())

test('the done share of a lane grows from 0 to 1, and its last message is the result', async () => {
  addBlocks(learning)
  addBlocks(expert)
  await freshDevice()
  const { ground, given } = (await openCourse('garden'))!
  const short = { ...ground, course: { ...ground.course, seconds: 20 } }
  const lane = { kind: 'hand', racer: given.hand } as const
  workersHere(() => import('./worker.ts'))
  const worker = newWorker()
  const messages: Answered[] = []
  await new Promise<void>((done) => {
    worker.onmessage = ({ data }: MessageEvent<Answered>) => {
      messages.push(data)
      if (data.result) done()
    }
    worker.postMessage({ ground: short, lane, seed: 1 } satisfies Asked)
  })
  const shares = messages.map(({ done }) => done)
  expect(shares.length).toBeGreaterThan(2)
  expect(shares).toEqual(shares.toSorted((a, b) => a - b))
  expect([shares[0], shares.at(-1)]).toEqual([0, 1])
  expect(Math.max(...shares.slice(0, -1))).toBeLessThan(1)
  expect(messages.at(-1)!.result).toEqual(structuredClone(finish(race(short, [lane], 1))[0]))
})
