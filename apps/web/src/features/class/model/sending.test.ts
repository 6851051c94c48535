// Property: whatever happens between a device and the class, nothing is lost and nothing is doubled. The class is the real
// one on a real database; a device is a browser's database with pages of its own.
import { isLong } from '@botgarten/numbers/testing'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import type { Ask } from '#storage/ask.ts'
import {
  Cable,
  headsIn,
  inBins,
  namesOfVersions,
  newDevice,
  newPupil,
  scene,
  settle,
  takeOneBack,
  Work,
} from './testing/devices.ts'
import { playAndSettle, someSteps } from './testing/steps.ts'

test(
  'two devices edit, throw away, lose the network, crash and send twice: nothing is lost, nothing is doubled',
  { timeout: isLong ? 900_000 : 60_000 },
  async () => {
    const devices = [await newDevice(), await newDevice()] as const
    await fc.assert(
      fc.asyncProperty(someSteps, fc.boolean(), async (steps, own) => {
        const { pupil, heads } = await playAndSettle(steps, devices, own)
        expect(new Set(heads).size).toBe(heads.length)
        for (const one of ['fear', 'friendship']) {
          const names = await namesOfVersions(pupil, one)
          expect(new Set(names).size).toBe(names.length)
        }
      }),
      {
        numRuns: isLong ? 1500 : 40,
        examples: [
          [
            [
              { kind: 'edit', device: 0, id: 'friendship' },
              { kind: 'send', device: 0, fate: 'arrives' },
              { kind: 'throw', device: 0, id: 'friendship' },
              { kind: 'back', device: 0 },
            ],
            false,
          ],
          // The version in the class is deleted before the child has chosen.
          [
            [
              { kind: 'edit', device: 0, id: 'fear' },
              { kind: 'send', device: 0, fate: 'arrives' },
              { kind: 'throw', device: 0, id: 'fear' },
              { kind: 'edit', device: 1, id: 'fear' },
              { kind: 'sendAll', device: 1 },
            ],
            false,
          ],
        ],
      },
    )
  },
)

test('a child unplugs with three unsent saves, another signs in and plugs in: nothing is mixed, nothing lost', async () => {
  const laptop = await newDevice()
  const tablet = await newDevice()
  const [fox, owl] = [await newPupil(), await newPupil()]
  const work = new Work()
  for (let edits = 0; edits < 3; edits++) await work.edit(laptop, 'fear')
  // The owl's session answers now, and the fox's page is still open.
  const wrong = new Cable(owl, fox.id)
  expect(await laptop.page.sendAll(wrong.ask)).toBe('otherPupil')
  expect(await headsIn(owl)).toEqual([])
  // The fox works on another device meanwhile, and comes back.
  const cable = new Cable(fox)
  await work.edit(tablet, 'fear')
  expect(await tablet.page.sendAll(cable.ask)).toBeNull()
  await settle([laptop, tablet], cable, true)
  expect(work.lostWith(await headsIn(fox))).toEqual([])
  expect(await headsIn(owl)).toEqual([])
})

test('what is thrown away is thrown away in the class and on the other device, and comes back from the bin', async () => {
  const { laptop, tablet, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  expect(await tablet.page.load('fear')).not.toBeNull()
  cable.fate = 'isLost'
  await laptop.page.throwAway('fear')
  expect(await laptop.page.sendAll(cable.ask)).toBe('away')
  cable.fate = 'arrives'
  // The class has it still, and it stays away from here all the same.
  await laptop.page.fetchWork(cable.ask)
  expect(await laptop.page.load('fear')).toBeNull()
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual([])
  expect(await tablet.page.load('fear')).toBeNull()
  expect(await inBins([tablet])).toEqual(['work 1'])
  await takeOneBack(laptop)
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual(['work 1'])
  expect((await tablet.page.load('fear'))?.project.name).toBe('work 1')
})

test('work that another device has done since is not thrown away with what was before it', async () => {
  const { laptop, tablet, pupil, cable, work } = await scene()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  await work.edit(tablet, 'fear')
  expect(await tablet.page.sendAll(cable.ask)).toBeNull()
  await laptop.page.throwAway('fear')
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual(['work 2'])
  expect((await laptop.page.load('fear'))?.project.name).toBe('work 2')
})

test('what the class does not take stays on the device, and the next change is sent again', async () => {
  const device = await newDevice()
  const pupil = await newPupil()
  const { ask } = new Cable(pupil)
  const work = new Work()
  await work.edit(device, 'fear')
  let refuses = true
  const picky: Ask = (method, path, body) =>
    refuses && method === 'PUT'
      ? Promise.resolve({ kind: 'refused', status: 413, code: 'tooBig', facts: {} })
      : ask(method, path, body)
  expect(await device.page.sendAll(picky)).toBeNull()
  expect((await device.page.whereabouts()).get('fear')).toEqual({ kind: 'refused', reason: 'tooBig' })
  refuses = false
  expect(await device.page.sendNext(picky)).toBe('none')
  await work.edit(device, 'fear')
  expect(await device.page.sendAll(picky)).toBeNull()
  expect(await headsIn(pupil)).toEqual(['work 2'])
})

test.each(['tooManyProjects', 'pupilFull'])(
  'a project that is one too many for the class (%s) is sent again once another one is deleted',
  async (reason) => {
    const { laptop, pupil, cable, work } = await scene()
    await work.edit(laptop, 'friendship')
    expect(await laptop.page.sendAll(cable.ask)).toBeNull()
    await work.edit(laptop, 'fear')
    const facts = { reason }
    let isFull = true
    const full: Ask = (method, path, body) => {
      if (method === 'DELETE') isFull = false
      return isFull && method === 'PUT'
        ? Promise.resolve({ kind: 'refused', status: 422, code: 'projectRefused', facts })
        : cable.ask(method, path, body)
    }
    expect(await laptop.page.sendAll(full)).toBeNull()
    expect((await laptop.page.whereabouts()).get('fear')).toEqual({ kind: 'refused', ...facts })
    await laptop.page.throwAway('friendship')
    expect(await laptop.page.sendAll(full)).toBeNull()
    expect((await laptop.page.whereabouts()).get('fear')).toEqual({ kind: 'waiting' })
    expect(await laptop.page.sendAll(full)).toBeNull()
    expect(await headsIn(pupil)).toEqual(['work 2'])
  },
)

test.each([
  ['full', 507, 'classFull'],
  ['trouble', 507, 'diskFull'],
  ['trouble', 503, 'busy'],
  ['slow', 429, 'tooFast'],
  ['slow', 429, 'classTooFast'],
  ['slow', 429, 'tooMuchAtOnce'],
  ['trouble', 500, 'ourFault'],
  ['signedOut', 401, 'join'],
  ['ended', 410, 'classEnded'],
  ['hidden', 423, 'classHidden'],
] as const)(
  'a class that answers %s (%i %s) gets the save later, under the same name',
  async (pause, status, code) => {
    const device = await newDevice()
    const pupil = await newPupil()
    const { ask } = new Cable(pupil)
    await new Work().edit(device, 'fear')
    const paths: string[] = []
    const seen =
      (next: Ask): Ask =>
      (method, path, body) => {
        paths.push(path)
        return next(method, path, body)
      }
    const refused: Ask = () => Promise.resolve({ kind: 'refused', status, code, facts: {} })
    expect(await device.page.sendAll(seen(refused))).toBe(pause)
    expect((await device.page.whereabouts()).get('fear')).toEqual({ kind: 'waiting' })
    expect(await device.page.sendAll(seen(ask))).toBeNull()
    expect(paths[1]).toBe(paths[0])
  },
)
