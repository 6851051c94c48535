import 'fake-indexeddb/auto'
import type { Project } from '@botgarten/programs'
import { afterEach, describe, expect, test, vi } from 'vitest'
import { withRobot } from '#lab/robots.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { friendship } from '#storage/testing/sample.ts'
import { fetchWords } from '#words/message.ts'
import { Debugger } from './debugger.svelte.ts'
import { noValues } from './values.ts'

afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

/** A debugger on a program that runs frame by frame. */
function debugging(project: Project = friendship) {
  const draw = screen()
  const { session } = sessionOf(project, { isCard: false })
  session.learnFirst = () => false
  const looking = new Debugger(session)
  session.lab.run()
  const frames = () => {
    for (let frame = 0; frame < 3; frame += 1) draw()
  }
  return { session, looking, frames }
}

describe('a stop', () => {
  test('pauses the run before its block, and the run waits there', () => {
    const { session, looking, frames } = debugging()
    looking.toggleStop('net')
    session.start()
    frames()
    expect([looking.stops, session.lab.view.phase, looking.waits]).toEqual([['net'], 'paused', true])
  })

  test('that is toggled again is gone, and the run passes its block', () => {
    const { session, looking, frames } = debugging()
    looking.toggleStop('net')
    looking.toggleStop('forever')
    looking.toggleStop('net')
    expect(looking.stops).toEqual(['forever'])
    looking.toggleStop('forever')
    expect(looking.stops).toEqual([])
    session.start()
    frames()
    expect([session.lab.view.phase, looking.waits]).toEqual(['running', false])
  })

  test('holds only while the debugger is open, and is there again when it opens', () => {
    const { session, looking, frames } = debugging()
    looking.toggleStop('net')
    looking.open = false
    session.start()
    frames()
    expect([session.lab.view.phase, looking.marks.stops, looking.open]).toEqual(['running', [], false])
    looking.open = true
    frames()
    expect([session.lab.view.phase, looking.marks.stops]).toEqual(['paused', ['net']])
  })

  test('does not count as waiting where the run was paused elsewhere', () => {
    const { session, looking, frames } = debugging()
    session.start()
    frames()
    session.lab.pause()
    looking.toggleStop('start')
    expect([session.lab.view.phase, looking.waits]).toEqual(['paused', false])
  })

  test('waits for one robot while the others are elsewhere', () => {
    const { document } = withRobot({ ...friendship }, 'bo', 'own')
    const { session, looking, frames } = debugging({ ...friendship, ...document })
    looking.toggleStop('net')
    session.start()
    frames()
    expect(session.lab.view.robots).toHaveLength(2)
    expect([session.lab.view.phase, looking.waits]).toEqual(['paused', true])
  })
})

test('values are looked up at blocks only while a run is on and the debugger is open', () => {
  const { session, looking, frames } = debugging()
  const isLookedUp = () => looking.marks.values !== noValues
  expect([session.lab.facts.phase, isLookedUp()]).toEqual(['ready', false])
  session.start()
  frames()
  expect([session.lab.facts.phase, isLookedUp()]).toEqual(['running', true])
  session.lab.pause()
  expect([session.lab.facts.phase, isLookedUp()]).toEqual(['paused', true])
  looking.open = false
  expect(isLookedUp()).toBe(false)
})

test('truth values are displayed in the language of the screen', async () => {
  await fetchWords('expert')
  const { looking } = debugging()
  expect(looking.words).toEqual({ locale: 'en', yes: 'true', no: 'false' })
})
