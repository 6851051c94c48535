import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { Ask } from '#storage/ask.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { Outbox } from './outbox.ts'
import type { Pause } from './sending.ts'

const noClass: Ask = () => Promise.resolve({ kind: 'away' })

beforeEach(async () => {
  await freshDevice()
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
})
afterEach(() => void vi.useRealTimers())

/** How often an outbox has tried after an hour if each try ends so. */
async function triesInAnHour(pause: Pause): Promise<number> {
  let tries = 0
  const outbox = new Outbox(
    noClass,
    () => {},
    () => Promise.resolve(tries++ < 9 ? pause : null),
  )
  await outbox.flush()
  for (let round = 0; round < 40; round++) {
    vi.advanceTimersByTime(90_000)
    for (let turn = 0; turn < 50; turn++) await new Promise((done) => setImmediate(done))
  }
  return tries
}

test.each(['signedOut', 'otherPupil', 'ended'] as const)(
  'a page whose pupil may send nothing more (%s) does not ask again and again',
  async (pause) => {
    expect(await triesInAnHour(pause)).toBe(1)
  },
)

test.each(['away', 'full', 'trouble'] as const)(
  'a page tries until the class takes its work, and then rests: %s',
  async (pause) => {
    expect(await triesInAnHour(pause)).toBe(10)
  },
)
