import { beforeEach, expect, test, vi } from 'vitest'
import { PlaneView, type Tool } from './plane.svelte.ts'
import { Playground } from './playground.svelte.ts'

let tool: Tool = 'look'
let plane: PlaneView
beforeEach(() => {
  tool = 'look'
  const playground = new Playground({
    kept: null,
    ...{ keep: vi.fn(), flush: vi.fn(), close: vi.fn() },
  })
  playground.turnTo('points')
  plane = new PlaneView(playground, () => tool)
  plane.room = { width: 746, height: 546 }
})

test('keys move the pen up to the edges of the plane, and it adds a point there', () => {
  plane.movePen(2, -1)
  expect(plane.cursor).toEqual({ x: 7, y: 4 })
  plane.movePen(20, -20)
  expect(plane.cursor).toEqual({ x: 10, y: 0 })
  tool = 'add'
  plane.usePen()
  const added = plane.playground.work.table.rows.at(-1)!
  expect([added[0], added[1]]).toEqual([expect.closeTo(10, 9), expect.closeTo(0, 9)])
  plane.movePen(-20, 20)
  expect(plane.cursor).toEqual({ x: 0, y: 10 })
})

test('shows where flags were before they moved, and nothing before the first step', () => {
  expect(plane.old).toEqual([])
  const { playground } = plane
  // All points join; then all flags move.
  playground.placeFlag(0, [0, 0], false)
  playground.stepAll()
  const from = plane.flags[0]
  playground.stepAll()
  expect(plane.old.find(({ flag }) => flag === 0)).toEqual({ flag: 0, from, to: plane.flags[0] })
  plane.grab(0)
  expect(plane.old).toEqual([])
  plane.drop()
  playground.takeOwn()
  playground.name(0, 'Left')
  expect(plane.old).toEqual([])
})
