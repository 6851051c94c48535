import 'fake-indexeddb/auto'
import { moveStation } from '@botgarten/maps/own'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { freshDevice } from '#storage/testing/device.ts'
import { Designer } from './designer.svelte.ts'
import { Keys } from './keys.svelte.ts'
import { openedWith, row } from './testing/opened.ts'

let designer: Designer
let keys: Keys
beforeEach(async () => {
  await freshDevice()
  designer = new Designer(await openedWith(row))
  keys = new Keys(designer)
})
afterEach(() => designer.close())

const station = (index: number) => ({ kind: 'station', index }) as const
const road = (index: number) => ({ kind: 'road', index }) as const

/** Returns whether the page itself has nothing to do with the key any more. */
function press(key: string, target: ReturnType<typeof station | typeof road>, shiftKey = false): boolean {
  let isTaken = false
  keys.press({ key, shiftKey, preventDefault: () => (isTaken = true) } as unknown as KeyboardEvent, target)
  return isTaken
}

test('arrows move a station by 10 units, with Shift by 40', () => {
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowDown', 'ArrowLeft']) press(key, station(0))
  expect(designer.settled).toEqual(moveStation(row, 0, { x: 210, y: 510 }))
  press('ArrowUp', station(0), true)
  expect(designer.settled).toEqual(moveStation(row, 0, { x: 210, y: 470 }))
})

test('arrows leave a road alone, and keys that mean nothing stay those of the page', () => {
  expect([press('ArrowRight', road(0)), press('a', station(0)), press('Tab', road(0))]).toEqual([
    false,
    false,
    false,
  ])
  expect(designer.canUndo).toBe(false)
  expect(press('ArrowRight', station(0))).toBe(true)
})

test.each(['Delete', 'Backspace'])('%s removes a station with its roads, and a road alone', (key) => {
  press(key, road(1))
  expect([designer.settled.stations.length, designer.settled.roads]).toEqual([3, [row.roads[0]]])
  press(key, station(0))
  expect([designer.settled.stations.length, designer.settled.roads]).toEqual([2, []])
})

test.each(['Enter', ' '])('"%s" opens what is pressed', (key) => {
  press(key, road(0))
  expect(designer.chosen).toEqual(road(0))
  press(key, station(2))
  expect([designer.chosen, keys.first]).toEqual([station(2), null])
})

test('with the tool for roads two stations one after the other are joined', () => {
  designer.tool = 'road'
  press('Enter', station(2))
  expect([keys.first, designer.chosen]).toEqual([2, station(2)])
  press('Enter', station(0))
  expect(designer.settled.roads.at(-1)).toEqual({ from: 0, to: 2, bends: [] })
  expect(keys.first).toBeNull()
  // The same station again starts a new road.
  press('Enter', station(1))
  press('Enter', station(1))
  expect([keys.first, designer.settled.roads.length]).toEqual([1, 3])
})
