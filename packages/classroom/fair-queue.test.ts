import { expect, test } from 'vitest'
import { FairQueue } from './fair-queue.ts'

/** Jobs that note when they run; the first one waits for `start`. */
function notes() {
  const queue = new FairQueue()
  const { promise: isStarted, resolve: start } = Promise.withResolvers<void>()
  const ran: string[] = []
  const running: Promise<unknown>[] = []
  const add = (classId: string, pupil: string, name: string) =>
    running.push(
      queue.run({ class: classId, pupil }, async () => {
        await isStarted
        ran.push(name)
      }),
    )
  return { queue, add, ran, end: () => (start(), Promise.all(running)) }
}

test('however many jobs one pupil has, that of another class is next, and then a classmate has a turn', async () => {
  const { add, ran, end } = notes()
  for (let at = 1; at <= 5; at++) add('5b', 'fox', `fox ${at}`)
  add('5b', 'owl', 'owl')
  add('6a', 'hare', 'hare 1')
  add('6a', 'hare', 'hare 2')
  await end()
  expect(ran).toEqual(['fox 1', 'hare 1', 'owl', 'hare 2', 'fox 2', 'fox 3', 'fox 4', 'fox 5'])
})

test('one job runs at a time, and requests that wait have a turn between two', async () => {
  const queue = new FairQueue()
  let [running, most] = [0, 0]
  const order: string[] = []
  const job = (name: string) => async () => {
    most = Math.max(most, ++running)
    await Promise.resolve()
    running--
    order.push(name)
  }
  const both = [
    queue.run({ class: '5b', pupil: 'fox' }, job('first')),
    queue.run({ class: '5b', pupil: 'fox' }, job('second')),
  ]
  setImmediate(() => order.push('request'))
  await Promise.all(both)
  expect(order).toEqual(['first', 'request', 'second'])
  expect(most).toBe(1)
})

test('a job that fails rejects its own promise, and the next one runs', async () => {
  const { queue, add, ran, end } = notes()
  const failed = queue.run({ class: '5b', pupil: 'fox' }, () => Promise.reject(new Error('broken')))
  add('5b', 'fox', 'next')
  await expect(failed).rejects.toThrow('broken')
  await end()
  expect(ran).toEqual(['next'])
  expect(await queue.run({ class: '6a', pupil: 'hare' }, () => Promise.resolve(7))).toBe(7)
})
