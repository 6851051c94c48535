// A device deletes projects when its pupil signs out: only those that the class has just confirmed.
import { afterAll, beforeEach, expect, test, vi } from 'vitest'
import type { Ask, Reply } from '#storage/ask.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import {
  backUp,
  Cable,
  headsIn,
  hideClass,
  newDevice,
  newPupil,
  Work,
  type Device,
  type Pupil,
} from './testing/devices.ts'

beforeEach(() => void freshLocalStorage())
afterAll(() => void vi.unstubAllGlobals())

async function memberOn({ page }: Device, pupil: Pupil, cable: Cable) {
  const { Member } = await page.member()
  const account = { pupil: pupil.id, class: pupil.class, nickname: 'Fuchs', className: '5b' }
  return new Member(account, cable.ask)
}

async function begin() {
  const [device, pupil] = [await newDevice(), await newPupil()]
  const cable = new Cable(pupil)
  const work = new Work()
  await work.edit(device, 'fear')
  return { device, pupil, cable, work, member: await memberOn(device, pupil, cable) }
}

const isOn = async ({ page }: Device, id: string) => (await page.load(id)) !== null

test('before the class has confirmed a project, the page does not call it saved in the class', async () => {
  const { device, pupil, cable, member } = await begin()
  await member.outbox.flush()
  expect(member.placeOf('fear')).toMatchObject({ kind: 'class' })
  expect(member.allConfirmed).toBe(true)
  // The page is opened again while the class cannot be reached.
  cable.fate = 'isLost'
  const again = await memberOn(device, pupil, cable)
  await again.outbox.flush()
  expect(again.pause).toBe('away')
  expect(again.placeOf('fear')).toEqual({ kind: 'waiting' })
  expect(again.allConfirmed).toBe(false)
})

test('after too many changes of a raised hand the sentence is another one than for a class that cannot be reached', async () => {
  const { device, pupil, cable } = await begin()
  const { Member } = await device.page.member()
  const account = { pupil: pupil.id, class: pupil.class, nickname: 'Fuchs', className: '5b' }
  let reply: Reply | null = { kind: 'refused', status: 429, code: 'tooManyHands', facts: { seconds: 2 } }
  const ask: Ask = (...request) => (reply === null ? cable.ask(...request) : Promise.resolve(reply))
  const member = new Member(account, ask)
  expect(await member.raiseHand(true)).toBe('often')
  expect(member.handUp).toBe(false)
  reply = { kind: 'away' }
  expect(await member.raiseHand(true)).toBe('away')
  reply = null
  expect(await member.raiseHand(true)).toBeNull()
  expect(member.handUp).toBe(true)
})

test('signing out deletes the projects that the class has', async () => {
  const { device, pupil, member } = await begin()
  await member.leave()
  expect(await headsIn(pupil)).toEqual(['work 1'])
  expect(await isOn(device, 'fear')).toBe(false)
})

test('signing out after a restore sends the lost work again before it is deleted on the device', async () => {
  const { device, pupil, work, member } = await begin()
  const putBack = await backUp(pupil)
  await work.edit(device, 'friendship')
  await member.outbox.flush()
  expect((await headsIn(pupil)).toSorted()).toEqual(['work 1', 'work 2'])
  await putBack()
  expect(await headsIn(pupil)).toEqual([])
  await member.leave()
  expect((await headsIn(pupil)).toSorted()).toEqual(['work 1', 'work 2'])
  expect(await isOn(device, 'fear')).toBe(false)
})

test('signing out while the class does not answer leaves the work on the device', async () => {
  const { device, cable, member } = await begin()
  await member.outbox.flush()
  expect(member.waiting).toBe(0)
  cable.fate = 'isLost'
  await member.leave()
  expect(await isOn(device, 'fear')).toBe(true)
})

test('a mark of the class that the page has not seen makes it compare, and lost work is sent again', async () => {
  const { pupil, cable, member } = await begin()
  const putBack = await backUp(pupil)
  await member.outbox.flush()
  await putBack()
  expect(await headsIn(pupil)).toEqual([])
  await member.enter()
  await expect.poll(() => headsIn(pupil)).toEqual(['work 1'])
  expect(cable.requests).toContain('PUT')
})

test('while the class is hidden, signing out leaves the work on the device, and it is sent once the class is shown', async () => {
  const { device, pupil, cable, member } = await begin()
  const show = await hideClass(pupil)
  await member.outbox.flush()
  expect(member.pause).toBe('hidden')
  expect(await member.enter()).toBe('hidden')
  await member.leave()
  expect(await isOn(device, 'fear')).toBe(true)
  await show()
  await (await memberOn(device, pupil, cable)).outbox.flush()
  expect(await headsIn(pupil)).toEqual(['work 1'])
})
