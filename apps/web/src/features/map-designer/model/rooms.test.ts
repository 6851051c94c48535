import 'fake-indexeddb/auto'
import { emptyRooms } from '@botgarten/maps/own'
import type { RoomMap } from '@botgarten/programs'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { freshDevice } from '#storage/testing/device.ts'
import { RoomDesigner } from './rooms.svelte.ts'
import { openedWith } from './testing/opened.ts'

let designer: RoomDesigner
beforeEach(async () => {
  await freshDevice()
  // SFF
  // FFG
  designer = new RoomDesigner(await openedWith(emptyRooms('Rooms', 3, 2)))
})
afterEach(() => designer.close())

test('a tap makes of a room what the tool says, and a second one floor again', () => {
  expect([designer.columns, designer.ends]).toEqual([3, { start: 0, goals: [5] }])
  designer.tap(1)
  expect([designer.map.rows, designer.at, designer.refused]).toEqual([['SWF', 'FFG'], 1, null])
  designer.tool = 'trap'
  designer.tap(2)
  designer.tap(2)
  expect(designer.map.rows).toEqual(['SWF', 'FFG'])
  designer.undo()
  expect(designer.map.rows).toEqual(['SWH', 'FFG'])
})

test('start and last treasure stay: the room that was refused is named, until the next tap', () => {
  designer.tap(5)
  expect([designer.refused, designer.canUndo]).toEqual([5, false])
  designer.tap(0)
  expect(designer.refused).toBe(0)
  designer.tap(1)
  expect(designer.refused).toBeNull()
})

test('the moves of the shortest way are counted; behind walls there is none', () => {
  // Two to the right and one down.
  expect(designer.moves).toBe(3)
  designer.tap(2)
  designer.tap(1)
  expect([designer.map.rows, designer.moves]).toEqual([['SWW', 'FFG'], 3])
  designer.tap(3)
  expect(designer.moves).toBeNull()
})

test('the room that keys are on stays on the map when the map gets smaller', () => {
  designer.at = 5
  const smaller: RoomMap = { ...designer.map, rows: ['SF', 'FG'] }
  designer.change(smaller)
  expect([designer.at, designer.columns]).toEqual([3, 2])
  designer.undo()
  expect(designer.at).toBe(3)
})
