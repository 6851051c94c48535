import 'fake-indexeddb/auto'
import { afterEach, expect, test } from 'vitest'
import { LastRun } from './last-run.svelte.ts'
import { closeSessions, screen, sessionOf } from './testing/session.ts'

afterEach(closeSessions)

function opened() {
  const draw = screen()
  const { session } = sessionOf()
  session.learnFirst = () => false
  const last = new LastRun(session)
  const turn = () => session.weights.turn('net', 'eyeLeft', 'wheelRight', 0.5, 'whole')
  return { session, last, turn, draw }
}

test('a change before the start is tried when a run begins, not before', () => {
  const { session, last, turn } = opened()
  session.start()
  expect(last.tried).toBe(false)
  session.lab.stop()
  turn()
  expect(last.tried).toBe(false)
  session.start()
  expect(last.tried).toBe(true)
})

test('a change while Bo drives, or is paused, is tried at once', () => {
  for (const isPaused of [false, true]) {
    const { session, last, turn } = opened()
    session.start()
    if (isPaused) session.lab.pause()
    expect(last.tried).toBe(false)
    turn()
    expect(last.tried).toBe(true)
  }
})

test('a run that ends short of the goal has missed it; one that was not on has missed nothing', () => {
  const { session, last, draw } = opened()
  session.start()
  const stop = session.lab.run()
  for (let frame = 0; frame < 3; frame += 1) draw()
  stop()
  for (const phase of ['ready', 'ended'] as const) {
    last.turns(phase)
    expect(last.missed).toBeNull()
  }
  last.turns('running')
  last.turns('paused')
  expect(last.missed).toBeNull()
  last.turns('ended')
  expect(last.missed).toEqual(session.lab.missing()[0])
  expect(last.missed).not.toBeNull()
  last.turns('running')
  last.close()
  last.turns('running')
  expect(last.missed).toBeNull()
})

test('goals that a run from elsewhere reaches light no leaf, those from a start pose do', () => {
  const { session, last } = opened()
  session.apply({ kind: 'place', id: 'bo', after: { x: 111, y: 300, heading: 0 } })
  session.start()
  last.earns(['near'])
  expect(last.earned).toEqual([])
  session.toStart()
  session.start()
  last.earns(['near'])
  expect(last.earned).toEqual(['near'])
})
