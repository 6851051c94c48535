import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { addToBin, emptyBin, listBin, takeBack, throwAway, daysOfUse } from './bin.ts'
import { load, list, save } from './projects.ts'
import {
  deviceThatKeepsNothing,
  fillDisk,
  freshDevice,
  keysIn,
  putOldDevice,
  recordIn,
} from './testing/device.ts'
import { fear, friendship, hash, withPicture } from './testing/sample.ts'
import { writing } from './database.ts'

const day = 86_400_000
beforeEach(async () => {
  vi.useFakeTimers({ toFake: ['Date'], now: Date.UTC(2026, 10, 21, 12) })
  await freshDevice()
})
afterEach(() => void vi.useRealTimers())

const passes = (days: number) => vi.setSystemTime(Date.now() + days * day)
/** Botgarten is used on so many days, one after the other. */
async function uses(days: number) {
  for (; days > 0; days -= 1) {
    passes(1)
    await listBin()
  }
}
async function thrown(id = 'friendship', project = friendship): Promise<string> {
  await save(id, project, 0)
  const moved = await throwAway(id)
  if (moved.kind !== 'moved') throw new Error(moved.kind)
  return moved.id
}
const left = async () => (await listBin()).thrown.map((one) => one.left)

test('what is thrown away has 30 days of use, and is forgotten after them', async () => {
  await thrown()
  expect(await left()).toEqual([30])
  await uses(1)
  expect(await left()).toEqual([29])
  await uses(28)
  expect(await left()).toEqual([1])
  await uses(1)
  expect(await left()).toEqual([])
  expect(await keysIn('bin')).toEqual([])
})

test('a day counts once, however often one looks', async () => {
  await thrown()
  for (let times = 0; times < 40; times += 1) await listBin()
  vi.setSystemTime(Date.UTC(2026, 10, 21, 23, 59))
  expect(await left()).toEqual([30])
  vi.setSystemTime(Date.UTC(2026, 10, 22, 0, 1))
  expect(await left()).toEqual([29])
})

test('a clock that jumps ahead by 31 days, or by ten years, makes one day of it', async () => {
  await thrown()
  passes(31)
  expect(await left()).toEqual([29])
  passes(3650)
  expect(await left()).toEqual([28])
})

test('a clock that goes back and forth counts each new day once', async () => {
  await thrown()
  for (let sessions = 0; sessions < 5; sessions += 1) {
    const today = Date.now() + day
    vi.setSystemTime(0)
    await listBin()
    vi.setSystemTime(today)
    await listBin()
  }
  expect(await left()).toEqual([25])
})

test('a clock that stays behind forgets nothing', async () => {
  await thrown()
  for (let days = 0; days < 60; days += 1) {
    passes(-1)
    await listBin()
  }
  expect(await left()).toEqual([30])
})

test('what older versions have thrown away begins its 30 days, however long ago that was', async () => {
  const record = { id: 'bin-x', was: 'fear', project: fear, changed: 1, revision: 2, thrown: 5 }
  await putOldDevice([], [record])
  expect(await left()).toEqual([30])
  await uses(29)
  expect(await left()).toEqual([1])
  await uses(1)
  expect(await left()).toEqual([])
})

test.each([
  ['no number', 'x'],
  ['not whole', 0.5],
  ['in days to come', 99],
  ['without end', Infinity],
])('a record whose day is %s begins its 30 days', async (_, odd) => {
  const id = await thrown()
  await recordIn('bin', id, { ...((await recordIn('bin', id)) as object), day: odd })
  expect(await left()).toEqual([30])
  await uses(2)
  expect(await left()).toEqual([28])
})

test.each([
  ['no number', { count: 'x', last: '2026-11-21' }],
  ['below nothing', { count: -4, last: '2026-11-21' }],
  ['no day', { count: 1, last: 7 }],
])('a count of days that is %s forgets nothing', async (_, odd) => {
  await thrown()
  await recordIn('days', 'used', { id: 'used', ...odd })
  expect((await left())[0]).toBeGreaterThanOrEqual(29)
})

test('the last thrown comes first, with all that it was', async () => {
  await thrown('friendship', withPicture(1000))
  passes(0.1)
  await thrown('fear', fear)
  const { thrown: all, damaged } = await listBin()
  expect(damaged).toEqual([])
  expect(all.map(({ was, project }) => [was, project])).toEqual([
    ['fear', fear],
    ['friendship', withPicture(1000)],
  ])
})

test('what is thrown away leaves nothing behind, and comes back as it was under its key', async () => {
  const id = await thrown('friendship', withPicture(1000))
  for (const store of ['projects', 'revisions', 'pictures']) expect(await keysIn(store)).toEqual([])
  expect(await load('friendship')).toBeNull()
  const before = Date.now()
  passes(1)
  expect(await takeBack(id)).toEqual({ kind: 'moved', id: 'friendship' })
  expect(await load('friendship')).toEqual({
    ...{ id: 'friendship', project: withPicture(1000) },
    // It was changed when it was saved last; an old tab still holds the revision of then.
    ...{ changed: before, revision: before + day },
  })
  expect(await keysIn('pictures')).toEqual([['friendship', hash]])
  expect(await keysIn('bin')).toEqual([])
})

test('where its key has another project now, it gets one of its own', async () => {
  const id = await thrown('free-abc', friendship)
  await save('free-abc', fear, 0)
  const back = await takeBack(id)
  expect(back).toEqual({ kind: 'moved', id: expect.stringMatching(/^free-\w+$/) as string })
  const { projects } = await list()
  expect(projects.map(({ project }) => project.name).toSorted()).toEqual(['fear', 'friendship'])
})

test('what another tab has moved is gone', async () => {
  expect(await throwAway('nothing')).toEqual({ kind: 'gone' })
  expect(await takeBack('nothing')).toEqual({ kind: 'gone' })
})

test('emptying forgets what was seen and nothing else', async () => {
  const id = await thrown()
  await thrown('fear', fear)
  expect(await emptyBin([id])).toBeNull()
  expect((await listBin()).thrown.map(({ was }) => was)).toEqual(['fear'])
})

test('what comes from elsewhere goes on with its days', async () => {
  const one = { was: 'fear', project: fear, changed: 3, thrown: 4 }
  await uses(2)
  expect(await addToBin([{ ...one, daysIn: 12 }, { ...one, daysIn: 0 }])).toBeNull() // prettier-ignore
  expect((await left()).toSorted()).toEqual([18, 30])
  expect((await listBin()).thrown[0]).toMatchObject(one)
})

test('a damaged record lies beside the others, with all that it holds, and comes back as it is', async () => {
  const raw = { botgarten: 1, name: 'Mine', world: 'gone' }
  const good = await thrown('fear', fear)
  await recordIn('bin', 'bin-x', { id: 'bin-x', was: 'free-x', project: raw, thrown: 'x', changed: NaN })
  const { thrown: all, damaged } = await listBin()
  expect(all.map(({ id }) => id)).toEqual([good])
  expect(damaged).toEqual([{ id: 'bin-x', name: 'Mine', changed: 0, raw }])
  expect(await takeBack('bin-x')).toEqual({ kind: 'moved', id: 'free-x' })
  expect((await list()).damaged).toEqual([{ id: 'free-x', name: 'Mine', changed: 0, raw }])
})

test.each([[undefined], [''], [7]])('a record that was at %s comes back as a free project', async (was) => {
  await listBin()
  await recordIn('bin', 'bin-x', { id: 'bin-x', was, project: fear, thrown: 1, changed: 1 })
  expect(await takeBack('bin-x')).toEqual({ kind: 'moved', id: 'free' })
})

test('on a full disk nothing is moved, and that is said', async () => {
  await save('friendship', friendship, 0)
  const makeRoom = fillDisk()
  expect(await throwAway('friendship')).toEqual({ kind: 'full' })
  expect(await addToBin([{ was: 'a', project: fear, changed: 1, thrown: 1, daysIn: 0 }])).toBe('full')
  makeRoom()
  expect((await load('friendship'))?.project).toEqual(friendship)
  expect((await listBin()).thrown).toEqual([])
})

test('where the browser keeps nothing, there is no bin, and that is said', async () => {
  await deviceThatKeepsNothing()
  expect(await listBin()).toEqual({ thrown: [], damaged: [] })
  expect(await throwAway('friendship')).toEqual({ kind: 'refused' })
  expect(await takeBack('x')).toEqual({ kind: 'refused' })
  expect(await emptyBin(['x'])).toBe('refused')
})

const days = (day: string) => writing((transaction) => daysOfUse(transaction, Date.parse(`${day}T12:00Z`)))

test('every later day counts once; a clock that goes back counts none twice', async () => {
  for (const [day, count] of [
    ['2026-11-22', 1],
    ['2026-11-22', 1],
    ['2026-11-23', 2],
    ['2026-11-20', 2],
    ['2026-11-21', 3],
  ] as const)
    expect(await days(day)).toBe(count)
})

test.each([['x'], [-1], [1.5], [0], [undefined]])(
  'a count that is %j begins again, on the same day too',
  async (count) => {
    await days('2026-11-22')
    await recordIn('days', 'used', { id: 'used', count, last: '2026-11-22' })
    expect(await days('2026-11-22')).toBe(1)
    expect(await days('2026-11-23')).toBe(2)
  },
)
