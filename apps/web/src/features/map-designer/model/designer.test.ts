import 'fake-indexeddb/auto'
import { addRoad, moveStation, removeRoad, removeStation, setRoad } from '@botgarten/maps/own'
import { afterEach, beforeEach, describe, expect, test } from 'vitest'
import { freshDevice } from '#storage/testing/device.ts'
import { Designer } from './designer.svelte.ts'
import { drawn, openedWith, row } from './testing/opened.ts'

let designer: Designer
beforeEach(async () => {
  await freshDevice()
  designer = new Designer(await openedWith(row))
})
afterEach(() => designer.close())

describe('a pull', () => {
  test('is seen at once, and is one step from before it when it ends', () => {
    designer.pull(moveStation(row, 0, { x: 300, y: 300 }))
    designer.pull(moveStation(row, 0, { x: 320, y: 310 }))
    expect([designer.map.stations[0], designer.settled]).toEqual([{ x: 320, y: 310 }, row])
    expect(designer.canUndo).toBe(false)
    designer.drop()
    expect(designer.settled.stations[0]).toEqual({ x: 320, y: 310 })
    designer.undo()
    expect([designer.map, designer.canUndo]).toEqual([row, false])
  })

  test('that moved nothing is no step', () => {
    designer.drop()
    expect(designer.canUndo).toBe(false)
  })

  test('ends where something else is changed meanwhile', () => {
    designer.pull(moveStation(row, 0, { x: 300, y: 300 }))
    designer.change(removeRoad(row, 1))
    expect(designer.map).toBe(designer.settled)
    designer.drop()
    expect(designer.settled.roads).toHaveLength(1)
  })

  test('moves lines and faults along, but not which stations can be reached', () => {
    const reach = designer.reach
    designer.pull(moveStation(row, 1, { x: 220, y: 500 }))
    // 20 units are 10 cm: too short to be driven, and the line ends at its new place.
    expect(designer.faults).toMatchObject([{ road: 0, kind: 'short' }])
    expect(designer.lines[0]!.there).toBe('M200 500L220 500')
    expect(designer.reach).toEqual(reach)
    expect(reach.way).toEqual([0, 1])
  })
})

describe('what is chosen', () => {
  test('stays as long as it is there', () => {
    designer.chosen = { kind: 'station', index: 2 }
    designer.change(setRoad(row, 0, { oneWay: true }))
    expect(designer.chosen).toEqual({ kind: 'station', index: 2 })
    designer.change(removeStation(row, 2))
    expect(designer.chosen).toBeNull()
  })

  test('is nothing once an undo has taken the road away', () => {
    designer.change(addRoad(row, 0, 2))
    designer.chosen = { kind: 'road', index: 2 }
    designer.undo()
    expect(designer.chosen).toBeNull()
    designer.chosen = { kind: 'road', index: 1 }
    designer.redo()
    expect(designer.chosen).toEqual({ kind: 'road', index: 1 })
  })
})

describe('a photo', () => {
  test('lies under the roads as one step', () => {
    expect(designer.layPhoto('/9j/AAAA')).toBeNull()
    expect(designer.map).toMatchObject({ dress: 'photo', photo: '/9j/AAAA' })
    designer.undo()
    expect(designer.map).toBe(row)
  })

  test('for which the project has no room is refused, and nothing changes', () => {
    expect(designer.layPhoto(`/9j/${'A'.repeat(600_000)}`)).toBe('room')
    expect([designer.map, designer.canUndo]).toEqual([row, false])
  })
})

test('the roads of the map are counted at once, one of both directions once', async () => {
  expect([designer.tries.all, designer.tries.tried, designer.tries.driven]).toEqual([2, 0, 0])
  designer.change(setRoad(row, 0, { oneWay: true }))
  expect(designer.tries.all).toBe(2)
  const empty = new Designer(await openedWith(drawn([])))
  expect(empty.tries.all).toBe(0)
  empty.close()
})
