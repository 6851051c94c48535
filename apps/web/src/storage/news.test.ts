import { afterEach, beforeEach, expect, test } from 'vitest'
import { takeBack, throwAway } from './bin.ts'
import { whenAnythingChanges } from './channel.ts'
import { goOnWithClass, goOnWithOwn, takeIn, takeVersionBack } from './outbox.ts'
import { add, rename, save } from './projects.ts'
import { deleteChild } from './study.ts'
import { fillDisk, freshDevice, until } from './testing/device.ts'
import { fear, friendship } from './testing/sample.ts'

// Other tabs and the outbox of the class wait for these announcements: without one, a project reaches the class only after
// the page is loaded again.
let heard = 0
let stop = () => {}
beforeEach(async () => {
  await freshDevice()
  await save('fear', fear, 0)
  await save('study-ab-fear', fear, 0)
  await settle()
  heard = 0
  stop = whenAnythingChanges(() => (heard += 1))
})
afterEach(() => stop())

const settle = async () => {
  for (let turns = 0; turns < 30; turns += 1) await new Promise((done) => setImmediate(done))
}
const copy = { id: 'friendship-copy', project: friendship, changed: 0 }
const fromClass = { id: 'friendship', savedAt: 0, project: friendship, revision: 4, hash: 'four' }
const intoBin = async () => {
  const moved = await throwAway('fear')
  await until(() => heard > 0)
  heard = 0
  return moved.kind === 'moved' ? moved.id : ''
}

const writes: readonly (readonly [write: string, announced: number, act: () => Promise<unknown>])[] = [
  ['a save', 1, () => save('friendship', friendship, 0)],
  ['a new name', 1, () => rename('fear', 'Night')],
  ['each of two projects of a file', 2, () => add([copy, { ...copy, id: 'other' }])],
  ['a project that goes into the bin', 1, () => throwAway('fear')],
  ['a project out of the bin', 1, async () => takeBack(await intoBin())],
  ['a project of the class', 1, () => takeIn(fromClass)],
  ['a copy of the class next to the own work', 1, () => goOnWithOwn(fromClass, copy)],
  ['the work of the class', 1, () => goOnWithClass(fromClass, () => copy)],
  ['the same with a copy of the own work', 2, () => goOnWithClass({ ...fromClass, id: 'fear' }, () => copy)],
  ['an earlier version', 1, () => takeVersionBack('fear', fear)],
  ['the deletion of a study', 1, () => deleteChild('ab')],
]
test.each(writes)('%s is announced', async (_, announced, act) => {
  await act()
  await until(() => heard === announced)
  await settle()
  expect(heard).toBe(announced)
})

test('a write that fails is not announced', async () => {
  fillDisk()
  expect(await add([copy])).not.toBeNull()
  await settle()
  expect(heard).toBe(0)
})
