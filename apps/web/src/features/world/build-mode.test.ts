import 'fake-indexeddb/auto'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import { BuildMode } from './build-mode.svelte.ts'

beforeEach(() => void screen())
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

const pose = { x: 60, y: 70, heading: 10 }

/** The world's pane on the card Friendship, with tools that only note each move. */
function pane() {
  const { session } = sessionOf()
  const placed: unknown[] = []
  const shop = { place: (...call: unknown[]) => placed.push(call), world: session.lab.document.world }
  const mode = new BuildMode(session, {} as LabUi, () =>
    Promise.resolve(() => Promise.resolve(shop as never)),
  )
  return { session, mode, shop, placed }
}

test('what a hand moves goes to the tools while a child builds, and is a robot of the session else', async () => {
  const { session, mode, shop, placed } = pane()
  const robot = session.robotId
  mode.place(robot, pose, 'end')
  expect(session.lab.document.world.robots[0]!.pose).toEqual(pose)
  await mode.toggle()
  expect(mode.shop).toBe(shop)
  mode.place(robot, { ...pose, x: 90 }, 'end')
  expect(placed).toEqual([[robot, { ...pose, x: 90 }, 'end']])
  expect(session.lab.document.world.robots[0]!.pose).toEqual(pose)
  await mode.toggle()
  expect([mode.on, mode.shop]).toEqual([false, null])
})
