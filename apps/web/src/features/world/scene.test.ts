import 'fake-indexeddb/auto'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { Command } from '#drawing/commands.ts'
import { letters } from '#figures/letters.svelte.ts'
import { Viewport } from '#figures/world/viewport.svelte.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { message } from '#words/message.ts'
import { Hand } from './hand.svelte.ts'
import { WorldScene } from './scene.svelte.ts'
import type { Shown } from './shown.ts'

beforeEach(() => {
  screen()
  vi.spyOn(letters, 'widthOf').mockImplementation((text) => 7 * text.length)
})
afterEach(() => {
  closeSessions()
  vi.restoreAllMocks()
  vi.unstubAllGlobals()
})

/** The scene of the card Friendship, in a pane of 600 × 400 px. */
function painted(more: Partial<Shown>) {
  const { lab, robotId } = sessionOf().session
  const { world } = lab.document
  const viewport = new Viewport(() => world)
  viewport.pane = { width: 600, height: 400 }
  const shown: Shown = {
    ...{ world, view: lab.view, robot: robotId, showRays: false, ports: null, badges: [], showTrail: false },
    ...{ gap: null, inside: null, senses: null, place: { x: 0, y: 0, width: 600, height: 400 } },
    ...more,
  }
  return new WorldScene(() => shown, viewport, new Hand(vi.fn()), undefined)
}

test('after a check that was missed it says where the run began, if that is known', () => {
  const gap = { from: { x: 10, y: 10 }, to: { x: 40, y: 50 }, label: '50 cm' }
  expect(painted({}).ghostNames).toBe('')
  expect(painted({ gap: { ...gap, began: null } }).ghostNames).toBe('')
  const began = { x: 20, y: 30, heading: 0 }
  expect(painted({ gap: { ...gap, began } }).ghostNames).toBe(message('world.began'))
})

test('what Bo has learned lies under it, and what it is paid lies over it', () => {
  const [learned, paid] = ['learned', 'paid'].map((text) => ({ kind: 'text', text }) as unknown as Command)
  const senses = { under: () => [learned!], over: () => [paid!] } as unknown as Shown['senses']
  const all = painted({ senses }).shapes
  expect(all.indexOf(learned!)).toBe(0)
  // Bo and the obstacles come between the two.
  expect(all.indexOf(paid!)).toBeGreaterThan(1)
})
