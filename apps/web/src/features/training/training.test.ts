import 'fake-indexeddb/auto'
import type { Project } from '@botgarten/programs'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { friendship } from '#storage/testing/sample.ts'
import { Opening } from './model/opening.svelte.ts'
import { Training } from './training.svelte.ts'

let frame: () => void
beforeEach(() => {
  frame = screen()
})
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

/** The card Friendship, on which a child shows its network something. */
function taught() {
  const { session } = sessionOf()
  const { showing, solo } = new Training(session)
  const network = session.outlines[0]!.id
  return { session, showing, solo, shown: () => session.examples.now(network)?.rows ?? [] }
}

test('a hand on the pad drives Bo and writes rows; when the drive is over, Bo waits, and one undo takes them', () => {
  const { session, showing, shown } = taught()
  showing.mode = 'drive'
  showing.hold({ left: 60, right: 60 })
  expect([showing.isHeld, showing.recording]).toEqual([true, true])
  const stop = session.lab.run()
  for (let k = 0; k < 30; k++) frame()
  showing.end()
  stop()
  expect([showing.isHeld, showing.recording, session.lab.facts.phase]).toEqual([false, false, 'paused'])
  expect(shown().length).toBeGreaterThan(1)
  session.undo.undo()
  expect(shown()).toEqual([])
})

test('a start that was looked at is left when Bo drives alone again', () => {
  const { solo } = taught()
  solo.shown = {
    ...{ number: 1, passed: false, missed: '', readings: null, trail: [] },
    start: { x: 50, y: 50, heading: 0 },
  }
  solo.go()
  expect([solo.isGoing, solo.shown]).toEqual([true, null])
  solo.close()
  expect(solo.isGoing).toBe(false)
})

test('a program without a network has no neurons to show', () => {
  const programs: Project['programs'] = { main: { ...friendship.programs['main']!, stacks: [] } }
  const { session } = sessionOf({ ...friendship, programs, brains: {} })
  const { inputs, outputs, showing } = new Training(session)
  expect([inputs, outputs, showing.rows]).toEqual([[], [], []])
})

describe('a file of examples', () => {
  const csv = (...rows: readonly string[]) =>
    new File([['eyeLeft,eyeRight,wheelLeft,wheelRight', ...rows].join('\n')], 'rows.csv')

  test('goes behind those that are there, and says how many it brought; or takes their place', async () => {
    const { showing, shown } = taught()
    const opening = new Opening(showing)
    await opening.open(csv('1,2,3,4', '5,6,7,8'))
    expect(opening.result).toMatchObject({ kind: 'opened', count: 2, outside: 0, isMixed: false })
    await opening.open(csv('120,10,11,12'))
    expect(opening.result).toMatchObject({ kind: 'opened', count: 1, outside: 1, isMixed: true })
    expect(shown().map((row) => row[6])).toEqual([1, 5, 120])
    opening.onlyThese()
    expect(shown().map((row) => row[6])).toEqual([120])
    expect(opening.result).toBeNull()
  })
})
