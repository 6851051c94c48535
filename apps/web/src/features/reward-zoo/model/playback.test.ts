import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { Playback } from './playback.svelte.ts'

let draw: ReturnType<typeof screen>
let count = 3
let playback: Playback
let now = 1000
beforeEach(() => {
  now = 1000
  vi.spyOn(performance, 'now').mockImplementation(() => now)
  draw = screen()
  count = 3
  playback = new Playback(() => count)
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

/** The clock is read at every start. */
function passes(milliseconds: number): void {
  draw(milliseconds)
  now += milliseconds
}
const state = () => [playback.index, playback.progress, playback.made, playback.over, playback.playing]

test('a move takes 600 ms, and all of them end at the last one', () => {
  expect(state()).toEqual([0, 0, 0, false, false])
  playback.restart()
  passes(150)
  expect(state()).toEqual([0, 0.25, 0, false, true])
  for (let frame = 0; frame < 4; frame += 1) passes(150)
  // 750 ms: the second move is a quarter over.
  expect(state()).toEqual([1, 0.25, 1, false, true])
  for (let frame = 0; frame < 7; frame += 1) passes(150)
  expect(state()).toEqual([2, 1, 3, true, false])
})

test('a page that slept does not catch up more than 250 ms', () => {
  playback.restart()
  passes(10_000)
  expect(playback.progress).toBeCloseTo(250 / 600, 12)
})

test('a step ends with its move, begins with the next one, and at the end begins again', () => {
  playback.step()
  for (let frame = 0; frame < 8; frame += 1) passes(100)
  expect(state()).toEqual([0, 1, 1, false, false])
  playback.step()
  passes(150)
  playback.pause()
  expect(state()).toEqual([1, 0.25, 1, false, false])
  passes(100)
  expect(playback.progress).toBe(0.25)
  playback.play()
  for (let frame = 0; frame < 20; frame += 1) passes(100)
  expect(playback.over).toBe(true)
  playback.step()
  passes(150)
  expect(state()).toEqual([0, 0.25, 0, false, true])
})

test('of nothing nothing is shown', () => {
  count = 0
  playback.play()
  passes(100)
  expect(state()).toEqual([0, 0, 0, false, false])
})
