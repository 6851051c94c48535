import { expect, test } from 'vitest'
import { noBus } from './bus.ts'
import { Hub } from './hub.ts'

test('a stream whose state could not be read gets it with the next flush', async () => {
  const hub = new Hub(noBus, { now: () => 0, elapsed: () => 0 })
  let reads = 0
  const read = () => {
    reads += 1
    return reads === 1 ? Promise.reject(new Error('The database is busy.')) : Promise.resolve({ hand: true })
  }
  const answer = hub.open({ class: 'c', pupil: 'p', teacher: null, read })
  await new Promise(setImmediate)
  expect(reads).toBe(1)
  await hub.flush()
  expect(reads).toBe(2)
  await hub.flush()
  expect(reads).toBe(2)
  await hub.close()
  expect(await answer.text()).toContain('"hand":true')
})
