// Property: after a restore of the class to any earlier state no work on a device is lost, and every project that a device
// shows as saved exists in the class.
import { isLong } from '@botgarten/numbers/testing'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import {
  backUp,
  headsIn,
  inBins,
  newDevice,
  scene,
  settle,
  takeOneBack,
  type Device,
} from './testing/devices.ts'
import { playAndSettle, stepsWithRestores } from './testing/steps.ts'

/** The names of the projects that a device says are in the class, by their ids. */
async function saidToBeInClass({ page }: Device): Promise<string[]> {
  const names: string[] = []
  for (const [id, { kind }] of await page.whereabouts())
    if (kind === 'class') names.push((await page.load(id))!.project.name)
  return names
}

test(
  'a class is restored to earlier states while two devices work: no work is lost, and projects called saved are in the class',
  { timeout: isLong ? 900_000 : 60_000 },
  async () => {
    const devices = [await newDevice(), await newDevice()] as const
    await fc.assert(
      fc.asyncProperty(stepsWithRestores, fc.boolean(), async (steps, own) => {
        const { cable, heads } = await playAndSettle(steps, devices, own)
        for (const { page } of devices) await page.fetchWork(cable.ask)
        for (const device of devices)
          for (const name of await saidToBeInClass(device)) expect(heads).toContain(name)
      }),
      { numRuns: isLong ? 1500 : 40 },
    )
  },
)

test('changes saved after the backup are sent again, also a new project, without a question', async () => {
  const { laptop, pupil, cable, work } = await scene()
  await work.edit(laptop, 'friendship')
  await settle([laptop], cable, true)
  const putBack = await backUp(pupil)
  await work.edit(laptop, 'friendship')
  await work.edit(laptop, 'fear')
  await settle([laptop], cable, true)
  await putBack()
  expect(await headsIn(pupil)).toEqual(['work 1'])
  await laptop.crash()
  await laptop.page.fetchWork(cable.ask)
  const places = await laptop.page.whereabouts()
  expect([...places.values()]).toEqual([{ kind: 'waiting' }, { kind: 'waiting' }])
  expect(await laptop.page.sendAll(cable.ask)).toBeNull()
  expect((await headsIn(pupil)).toSorted()).toEqual(['work 2', 'work 3'])
})

test('a change after a restore replaces the earlier version, without a question', async () => {
  const { laptop, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop], cable, true)
  const putBack = await backUp(pupil)
  await work.edit(laptop, 'fear')
  await settle([laptop], cable, true)
  await putBack()
  await work.edit(laptop, 'fear')
  expect(await laptop.page.sendAll(cable.ask)).toBeNull()
  expect((await laptop.page.whereabouts()).get('fear')).toMatchObject({ kind: 'class' })
  expect(await headsIn(pupil)).toEqual(['work 3'])
})

test('two devices differ after a restore to a revision that both know: the child chooses', async () => {
  const { laptop, tablet, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  const putBack = await backUp(pupil)
  await work.edit(laptop, 'fear')
  expect(await laptop.page.sendAll(cable.ask)).toBeNull()
  await putBack()
  await work.edit(tablet, 'fear')
  expect(await tablet.page.sendAll(cable.ask)).toBeNull()
  // Both call it revision 2.
  await laptop.page.fetchWork(cable.ask)
  expect((await laptop.page.whereabouts()).get('fear')).toEqual({ kind: 'conflict', revision: 2 })
  expect((await laptop.page.load('fear'))?.project.name).toBe('work 2')
  await settle([laptop, tablet], cable, true)
  expect((await headsIn(pupil)).toSorted()).toEqual(['work 2', 'work 3'])
})

test('a revision that was saved onto another one of the same number is refused, also by a page that did not look', async () => {
  const { laptop, tablet, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  const putBack = await backUp(pupil)
  await work.edit(laptop, 'fear')
  expect(await laptop.page.sendAll(cable.ask)).toBeNull()
  await putBack()
  await work.edit(tablet, 'fear')
  expect(await tablet.page.sendAll(cable.ask)).toBeNull()
  await work.edit(laptop, 'fear')
  expect(await laptop.page.sendAll(cable.ask)).toBeNull()
  expect((await laptop.page.whereabouts()).get('fear')).toEqual({ kind: 'conflict', revision: 2 })
  expect(await headsIn(pupil)).toEqual(['work 3'])
})

test('newer work of a restored class is loaded if it was made from the work here; otherwise the child chooses', async () => {
  const { laptop, tablet, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  await work.edit(laptop, 'friendship')
  await laptop.page.sendAll(cable.ask)
  const putBack = await backUp(pupil)
  await work.edit(laptop, 'friendship')
  await laptop.page.sendAll(cable.ask)
  await putBack()
  await tablet.page.fetchWork(cable.ask)
  for (const id of ['fear', 'friendship', 'friendship']) {
    await work.edit(tablet, id)
    expect(await tablet.page.sendAll(cable.ask)).toBeNull()
  }
  await laptop.page.fetchWork(cable.ask)
  expect((await laptop.page.load('fear'))?.project.name).toBe('work 4')
  expect((await laptop.page.whereabouts()).get('friendship')).toEqual({ kind: 'conflict', revision: 3 })
  expect((await laptop.page.load('friendship'))?.project.name).toBe('work 3')
})

test('a deleted project is deleted again after a restore, and is in the bin of each device', async () => {
  const { laptop, tablet, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  const putBack = await backUp(pupil)
  await laptop.page.throwAway('fear')
  expect(await laptop.page.sendAll(cable.ask)).toBeNull()
  await putBack()
  await laptop.page.fetchWork(cable.ask)
  expect(await laptop.page.load('fear')).toBeNull()
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual([])
  expect(await inBins([laptop, tablet])).toEqual(['work 1', 'work 1'])
})

test('work that another device has saved since a restore is not deleted with the earlier version', async () => {
  const { laptop, tablet, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  const putBack = await backUp(pupil)
  await laptop.page.throwAway('fear')
  expect(await laptop.page.sendAll(cable.ask)).toBeNull()
  await putBack()
  await work.edit(tablet, 'fear')
  expect(await tablet.page.sendAll(cable.ask)).toBeNull()
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual(['work 2'])
  expect((await laptop.page.load('fear'))?.project.name).toBe('work 2')
})

test('a project that is missing because another device deleted it is not sent again', async () => {
  const { laptop, tablet, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  await laptop.page.throwAway('fear')
  await laptop.page.sendAll(cable.ask)
  await tablet.page.fetchWork(cable.ask)
  expect(await tablet.page.load('fear')).toBeNull()
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual([])
})

test('a project that was restored from the bin is sent again if the class was restored to when it lay there', async () => {
  const { laptop, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop], cable, true)
  await laptop.page.throwAway('fear')
  await settle([laptop], cable, true)
  const putBack = await backUp(pupil)
  await takeOneBack(laptop)
  await settle([laptop], cable, true)
  await putBack()
  await laptop.page.fetchWork(cable.ask)
  expect((await laptop.page.load('fear'))?.project.name).toBe('work 1')
  expect(await laptop.page.sendAll(cable.ask)).toBeNull()
  expect(await headsIn(pupil)).toEqual(['work 1'])
})

test('once a device has compared itself with a restored class, it remembers the mark of that class', async () => {
  const { laptop, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop], cable, true)
  const putBack = await backUp(pupil)
  for (let edits = 0; edits < 3; edits++) {
    await work.edit(laptop, 'fear')
    await settle([laptop], cable, true)
  }
  await putBack()
  const markOfClass = async () => ((await pupil.browser.get('/projects')).body as { mark: string }).mark
  expect(await laptop.page.seenMark()).not.toBe(await markOfClass())
  await laptop.page.fetchWork(cable.ask)
  expect(await laptop.page.seenMark()).toBe(await markOfClass())
})
