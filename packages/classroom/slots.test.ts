import { expect, test } from 'vitest'
import { Refusal } from './refusal.ts'
import { Slots } from './slots.ts'

/** Notes which of several files of a teacher are let in. */
function filesOf(slots: Slots, teacher: string, count: number) {
  const begun: number[] = []
  const ends = Array.from({ length: count }, (_, at) => {
    const { entered, end } = slots.enter(teacher)
    void entered.then(() => begun.push(at))
    return end
  })
  return { begun, ends }
}
const settled = () => new Promise((resolve) => setImmediate(resolve))

test('two files of a teacher are written at once; the third waits until one has ended', async () => {
  const slots = new Slots(2, 20)
  const { begun, ends } = filesOf(slots, 'weber', 4)
  const other = filesOf(slots, 'otto', 1)
  await settled()
  expect(begun).toEqual([0, 1])
  expect(other.begun).toEqual([0])
  ends[1]!()
  // Its reader was cut off as well: that makes no further room.
  ends[1]!()
  await settled()
  expect(begun).toEqual([0, 1, 2])
  ends[0]!()
  await settled()
  expect(begun).toEqual([0, 1, 2, 3])
})

test('a file whose reader disconnects while it waits takes no turn', async () => {
  const { begun, ends } = filesOf(new Slots(2, 20), 'weber', 4)
  ends[2]!()
  ends[0]!()
  await settled()
  expect(begun).toEqual([0, 1, 3])
})

test('of the files of a teacher 20 wait at most', () => {
  const slots = new Slots(2, 20)
  const { ends } = filesOf(slots, 'weber', 22)
  expect(() => slots.enter('weber')).toThrow(new Refusal(429, 'tooManyExports', { seconds: 10 }))
  expect(() => slots.enter('otto')).not.toThrow()
  ends[0]!()
  expect(() => slots.enter('weber')).not.toThrow()
})
