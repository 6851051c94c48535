import '#storage/testing/device.ts'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { isSame, pseudonymOf, readLog, replay, tableOf, type StudyPlan } from '@botgarten/experiments/study'
import { drawWay } from '@botgarten/maps'
import { sceneOf, type Project } from '@botgarten/programs'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { LabSession } from '#lab/session.svelte.ts'
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

/** Draws this many frames of 50 ms. */
type Draw = (frames: number) => void

const railway = () => {
  const { card, world } = content.card('railway')!
  return cardProject(world, card, content.program('railway', 'solution')!, 'railway')
}
const fourWrong = (name: string) => {
  const { card, world } = content.card('four-wrong')!
  return cardProject(world, card, content.program('four-wrong', name)!, 'four-wrong')
}

/** Actions of a child in a lab, each with the events that its log has then. */
const sittings: {
  readonly [what: string]: {
    readonly project?: () => Project
    readonly events: readonly string[]
    readonly act: (session: LabSession, draw: Draw) => void
  }
} = {
  'goes back in time, turns a knob there and goes on': {
    events: ['knob', 'pause', 'look', 'branch'],
    act(session, draw) {
      session.weights.turn('net', 'eyeLeft', 'wheelLeft', 0.6, 'whole')
      session.start()
      draw(40)
      session.lab.pause()
      session.lab.goTo(60)
      session.weights.turn('net', 'eyeLeft', 'wheelLeft', 0.3, 'whole')
      session.resume()
      draw(20)
      session.lab.stop()
    },
  },
  'lets Bo learn its way by trying, and drive it': {
    project: railway,
    events: ['learned', 'rebuild'],
    act(session, draw) {
      const after = { seed: 1, key: 'railway', noted: true, moves: 640, runs: [] }
      session.apply({ kind: 'learned', program: 'main', after })
      const { scene } = drawWay(content.mapFile('railway')!, [3, 2, 1])
      session.apply({ kind: 'scene', after: scene })
      session.learnFirst = () => false
      session.start()
      draw(40)
      session.lab.stop()
    },
  },
  'shows examples and practises': {
    project: () => fourWrong('start'),
    events: ['training', 'brain'],
    act(session, draw) {
      const [network, brain] = Object.entries(fourWrong('solution').brains)[0]!
      session.apply({ kind: 'examples', network, after: brain.examples })
      session.apply({ kind: 'brain', id: network, after: brain })
      session.start()
      draw(40)
      session.lab.stop()
    },
  },
  'builds a world and steps through a program': {
    events: ['rebuild', 'step'],
    act(session, draw) {
      const before = sceneOf(session.lab.document.world)
      const wall = { id: 'wall', shape: { kind: 'rectangle', width: 20, height: 20 } } as const
      const pose = { x: 250, y: 250, heading: 0 }
      const obstacles = [...before.obstacles, { ...wall, pose, fixed: true, colour: '#B30006' } as const]
      session.apply({ kind: 'scene', after: { ...before, obstacles } })
      session.lab.step('block')
      session.lab.step('tick')
      session.resume()
      draw(40)
      session.lab.stop()
    },
  },
}

test.each(Object.entries(sittings))('a child that %s is replayed to the same hashes', async (_, one) => {
  const drawOne = screen()
  device.begin(pseudonymOf(1, 2), true)
  const { session } = sessionOf(one.project?.())
  const stop = session.lab.run()
  const leave = follow(session)
  one.act(session, (frames) => {
    for (let frame = 0; frame < frames; frame++) drawOne(50)
  })
  leave()
  device.end()
  stop()
  const lines = await logged()
  expect(lines.map(({ says }) => says.event)).toEqual(expect.arrayContaining([...one.events]))
  const ground = { floorOf: content.floorOf, checksOf: (card: string) => content.card(card)!.card.checks }
  const { runs, faults } = replay(lines, ground)
  expect(faults).toEqual([])
  expect(runs.length).toBeGreaterThan(0)
  expect(runs.every(isSame)).toBe(true)
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

test('after a child has ended, the device is ready for the next one of the same study', () => {
  device.begin(pseudonymOf(1, 2), true)
  device.end()
  expect([device.child, device.ready, device.plan]).toEqual([null, true, plan])
  device.close()
  device.end()
  expect([device.child, device.ready, device.plan]).toEqual([null, false, null])
})

test('a hint is logged once, however often the child reaches it', async () => {
  device.begin(pseudonymOf(1, 2), true)
  const { session } = sessionOf()
  const leave = follow(session)
  const reaches = (hints: number, starts: readonly number[]) =>
    session.apply({ kind: 'progress', after: { hints, starts } })
  reaches(1, [])
  reaches(1, [0])
  reaches(2, [0])
  reaches(2, [0, 1])
  leave()
  const lines = await logged()
  expect(lines.flatMap(({ says }) => (says.event === 'hint' ? [says.shown] : []))).toEqual([1, 2])
})

test('a lab that is opened on another page takes the log over', async () => {
  device.begin(pseudonymOf(1, 2), true)
  vi.resetModules()
  const { device: other } = await import('./device.svelte.ts')
  other.hold()
  device.look({ key: 'botgarten.study' })
  expect(device.writes).toBe(false)
  const leave = follow(sessionOf().session)
  expect(device.writes).toBe(true)
  leave()
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
