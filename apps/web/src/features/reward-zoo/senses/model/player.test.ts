import { afterEach, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { Player } from './player.svelte.ts'

afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

const pose = (x: number) => ({ x, y: 0, heading: 0 })
/** Two moves of five poses each. */
const drive = (from: number, coins: readonly number[]) => ({
  poses: Array.from({ length: 11 }, (_, at) => pose(from + at)),
  ...{ coins, posesAMove: 5 },
})

test('the coins of a move fall when it is over, and those of another drive are its own', () => {
  vi.spyOn(performance, 'now').mockReturnValue(0)
  const draw = screen()
  const player = new Player()
  expect(player.paid).toBeNull()
  player.show([drive(0, [1, -5]), drive(100, [2, 3])])
  expect([player.paid, player.trail]).toEqual([null, [pose(0)]])
  draw(80)
  expect([player.paid, player.trail.at(-1)]).toEqual([null, pose(4)])
  draw(20)
  expect([player.paid, player.trail.at(-1)]).toEqual([1, pose(6)])
  draw(67)
  expect([player.drive, player.paid]).toEqual([1, null])
  draw(100)
  expect([player.paid, player.trail.at(-1)]).toEqual([2, pose(106)])
  draw(100)
  expect([player.paid, player.playing]).toEqual([3, false])
})
