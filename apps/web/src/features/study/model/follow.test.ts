import '#storage/testing/device.ts'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { content } from '@botgarten/content/files'
import { isSame, pseudonymOf, readLog, replay, tableOf, type StudyPlan } from '@botgarten/experiments/study'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { allowed } from '#lab/allowed.svelte.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { deleteChild, deleteLogs, loggedHere, logFile } from '#storage/study.ts'
import { device } from './device.svelte.ts'
import { follow } from './follow.ts'
import { placeFor } from './locks.ts'

addBlocks(learning)

const plan: StudyPlan = {
  ...{ botgarten: 'study', version: 1, id: 'test', title: 'Test', seed: 3, groups: 3, children: 4 },
  modules: [
    { id: 'one', title: 'One', cards: ['friendship'] },
    { id: 'two', title: 'Two', cards: ['fear'] },
  ],
  ...{ order: 'fixed', level: 'plain', maps: null, log: true, word: 'stone' },
}

const kept = new Map<string, string>()
beforeEach(async () => {
  vi.stubGlobal('localStorage', {
    getItem: (name: string) => kept.get(name) ?? null,
    setItem: (name: string, text: string) => void kept.set(name, text),
    removeItem: (name: string) => void kept.delete(name),
  })
  vi.stubGlobal('addEventListener', () => {})
  vi.stubGlobal('removeEventListener', () => {})
  await deleteLogs()
  device.open(plan)
  device.handOut()
})
afterEach(() => {
  device.close()
  closeSessions()
  vi.unstubAllGlobals()
})

/** The log of this device, once all of it is kept. */
async function logged(pseudonym?: string) {
  device.keep()
  await vi.waitFor(async () => expect(await loggedHere()).not.toEqual([]))
  const { lines, faults } = readLog(await logFile(pseudonym))
  expect(faults).toEqual([])
  return lines
}

test('what a child does is written down once it has said yes, rests while it rests, and replays', async () => {
  const draw = screen()
  expect(device.begin(pseudonymOf(1, 2), true)).toBe(true)
  const { session } = sessionOf()
  const stop = session.lab.run()
  const leave = follow(session)
  session.start()
  for (let frame = 0; frame < 30; frame++) draw(50)
  session.askHint(1)
  device.rest()
  session.lab.stop()
  session.start()
  draw()
  device.wake()
  session.start()
  for (let frame = 0; frame < 10; frame++) draw(50)
  leave()
  device.end()
  stop()
  const lines = await logged()
  const events = lines.map(({ says }) => says.event)
  expect(events.slice(0, 4)).toEqual(['session', 'part', 'open', 'run'])
  expect(events.slice(events.indexOf('rest') - 1, events.indexOf('rest') + 2)).toEqual([
    'end',
    'rest',
    'open',
  ])
  expect(events.slice(-2)).toEqual(['end', 'over'])
  const ground = { floorOf: content.floorOf, checksOf: (card: string) => content.card(card)!.card.checks }
  const { runs, faults } = replay(lines, ground)
  expect([faults, runs.length, runs.every(isSame)]).toEqual([[], 2, true])
  expect(tableOf(lines)).toMatchObject([{ pseudonym: '0102X', tries: 2, hints: 1, places: 1 }])
})

test('of a child that says no, and of one whose number is not in the study, nothing is written', async () => {
  const draw = screen()
  expect(device.begin(pseudonymOf(4, 1), true)).toBe(false)
  expect(device.begin('0102A', true)).toBe(false)
  expect(device.begin(pseudonymOf(1, 2), false)).toBe(true)
  const { session } = sessionOf()
  const leave = follow(session)
  session.start()
  draw()
  leave()
  device.end()
  expect(await loggedHere()).toEqual([])
})

test('only the cards of the part are open, and each child has projects of its own', () => {
  expect(placeFor('friendship')).toBeNull()
  device.begin(pseudonymOf(2, 1), false)
  expect(placeFor('friendship')).toEqual({ project: `study-${pseudonymOf(2, 1)}-friendship` })
  expect([placeFor('fear'), placeFor('free'), allowed.level]).toEqual([null, null, 'plain'])
  device.goOn()
  expect([placeFor('friendship'), placeFor('fear')]).toEqual([
    null,
    { project: `study-${pseudonymOf(2, 1)}-fear` },
  ])
  device.close()
  expect(allowed.isOpen('free')).toBe(true)
})

test('one number is deleted without a trace, and the others stay', async () => {
  for (const number of [1, 2]) {
    device.begin(pseudonymOf(1, number), true)
    device.end()
  }
  await vi.waitFor(async () => expect(await loggedHere()).toHaveLength(2))
  await deleteChild(pseudonymOf(1, 1))
  expect((await logged()).map(({ says }) => says.pseudonym)).toEqual(Array(3).fill(pseudonymOf(1, 2)))
  expect(await logFile()).not.toContain(pseudonymOf(1, 1))
})

test('the page that was opened last writes, after the lines of the one before', async () => {
  device.begin(pseudonymOf(1, 2), true)
  vi.resetModules()
  const { device: other } = await import('./device.svelte.ts')
  expect(other.writes).toBe(false)
  other.hold()
  device.look({ key: 'botgarten.study' })
  expect([device.writes, other.writes]).toEqual([false, true])
  device.write({ event: 'hint', shown: 1 })
  other.write({ event: 'hint', shown: 2 })
  other.keep()
  await vi.waitFor(async () => expect(await logged()).toHaveLength(3))
  expect((await logged()).map(({ says }) => says)).toMatchObject([
    { event: 'session' },
    { event: 'part' },
    { event: 'hint', shown: 2 },
  ])
})

test('what was on its way when the page was left is taken up by the next one', async () => {
  device.begin(pseudonymOf(1, 2), true)
  device.write({ event: 'hint', shown: 1 })
  device.leave()
  expect(kept.get('botgarten.study-aside')).toContain('hint')
  expect((await logged()).map(({ says }) => says.event)).toEqual(['session', 'part', 'hint'])
})
