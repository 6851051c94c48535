import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { Playback } from './playback.svelte.ts'

/** Frames that are asked for; the test says when they come. */
let frames: FrameRequestCallback[] = []
const frameAt = (now: number) => frames.splice(0).forEach((next) => next(now))

beforeEach(() => {
  frames = []
  vi.stubGlobal('matchMedia', () => ({ matches: false }))
  vi.stubGlobal('requestAnimationFrame', (next: FrameRequestCallback) => frames.push(next))
  vi.stubGlobal('cancelAnimationFrame', () => (frames = []))
  vi.spyOn(performance, 'now').mockReturnValue(1000)
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

test('a frame that began before it was asked for shows the beginning', () => {
  const playback = new Playback()
  playback.speed = 1
  playback.begin(601)
  frameAt(990)
  expect([playback.at, playback.playing]).toEqual([0, true])
})

test('half of the time shows half of the way, all of it the end, and then it stands', () => {
  const playback = new Playback()
  playback.speed = 1
  playback.begin(601)
  frameAt(1000 + 8000)
  expect(playback.at).toBe(300)
  frameAt(1000 + 16_000)
  expect([playback.at, playback.playing, frames]).toEqual([600, false, []])
})

test('a moment that is chosen while it plays is shown, and playing stops there', () => {
  const playback = new Playback()
  playback.speed = 1
  playback.begin(601)
  frameAt(1000 + 4000)
  playback.goTo(20)
  expect([playback.at, playback.playing, frames]).toEqual([20, false, []])
  playback.goTo(900)
  expect([playback.at, playback.atEnd]).toEqual([600, true])
  playback.goTo(-1)
  expect(playback.at).toBe(0)
})
