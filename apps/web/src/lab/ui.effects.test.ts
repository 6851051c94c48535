import 'fake-indexeddb/auto'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import type { Project } from '@botgarten/programs'
import { flushSync } from 'svelte'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { closeSessions, screen, sessionOf } from './testing/session.ts'
import { LabUi } from './ui.svelte.ts'

addBlocks(learning)

let draw: (milliseconds?: number) => void
beforeEach(() => {
  freshLocalStorage()
  vi.stubGlobal('document', Object.assign(new EventTarget(), { hidden: false }))
  vi.stubGlobal('window', new EventTarget())
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] })
  draw = screen()
})
afterEach(() => {
  closeSessions()
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

const { card, world } = content.card('friendship')!
const solved = cardProject(world, card, content.program('friendship', 'solution')!, 'friendship')

function running(project: Project) {
  const { session } = sessionOf(project)
  session.learnFirst = () => false
  const ui = new LabUi(session)
  const close = ui.open()
  session.start()
  return { session, ui, close }
}

function frame() {
  draw()
  flushSync()
}

/** Draws frames until this holds, for at most a minute of the run. */
function until(holds: () => boolean) {
  for (let frames = 0; !holds(); frames += 1) {
    if (frames > 600) throw new Error('It did not come within a minute.')
    frame()
  }
}

test('a run that reaches every goal of the card is a success that counts', () => {
  const { ui, close } = running(solved)
  until(() => ui.success !== null)
  expect(ui.success).toBe('counts')
  close()
})

test('a bump is shown while Bo touches something, and can be read for four seconds afterwards', () => {
  const forward = content.card('forward')!
  const drives = cardProject(forward.world, forward.card, content.program('forward', 'solution')!, 'forward')
  const [bo] = drives.world.robots
  // It drives east into the square of Friendship, which is at 300, 200.
  const world = { ...solved.world, robots: [{ ...bo!, pose: { x: 230, y: 200, heading: 0 } }] }
  const { session, ui, close } = running({ ...drives, world })
  expect(ui.notice).toBeNull()
  until(() => ui.notice === 'bumped')
  vi.advanceTimersByTime(10_000)
  frame()
  expect(ui.notice).toBe('bumped')
  session.apply({ kind: 'place', id: session.robotId, after: { x: 100, y: 100, heading: 0 } })
  frame()
  vi.advanceTimersByTime(3999)
  expect(ui.notice).toBe('bumped')
  vi.advanceTimersByTime(1)
  expect(ui.notice).toBeNull()
  close()
})
