import { expect, test } from 'vitest'
import { actionFill, actionSign } from './action-signs.ts'
import type { Command, Group } from './commands.ts'
import { drawFan, drawFanNow, fieldSide, type Fan } from './fan.ts'

const actions = [
  { left: 50, right: 50 },
  { left: -25, right: 25 },
  { left: 25, right: -25 },
]
const fan: Fan = {
  fields: [
    [2, null, 2],
    [1, 1, 0],
    [1, 1, 0],
  ],
  now: [2, 2],
  actions,
}

const groups = (command: Command): readonly Command[] =>
  command.kind === 'group' ? [command, ...command.shapes.flatMap(groups)] : [command]
/** Middles of the fields. */
const placesOf = (fan: Fan, scale = 2) =>
  drawFan(fan, scale).shapes.map((one) => (one as Group).shapes[0] as { x: number; y: number })
const all = (shapes: readonly Command[]) => shapes.flatMap(groups)

test('there is a field for each pair of buckets, coloured by its best action, with its arrow', () => {
  const shapes = all([drawFan(fan, 2)])
  const filled = shapes.flatMap((one) => (one.kind === 'rect' && one.fill ? [one.fill] : []))
  expect(filled).toHaveLength(9)
  expect(filled.filter((fill) => fill === actionFill(1))).toHaveLength(4)
  const arrows = shapes.flatMap((one) => (one.kind === 'path' ? [one.d] : []))
  expect(arrows.filter((d) => d === actionSign(actions[0]!))).toHaveLength(2)
})

test('what both eyes see near is next to the robot, far and far is ahead of it, and lit', () => {
  const side = fieldSide(fan, 2)
  const places = placesOf(fan)
  const [nearest, farthest] = [places[0]!, places[8]!]
  expect(nearest.x).toBeCloseTo(0)
  expect(farthest.x).toBeCloseTo(0)
  expect(nearest.y - farthest.y).toBeCloseTo(4 * (side / Math.SQRT2))
  expect(drawFanNow(fan, 2)).toMatchObject([{ x: farthest.x, y: farthest.y }])
  expect(drawFanNow({ ...fan, now: null }, 2)).toEqual([])
  // What the left eye sees far lies to the left: x below 0.
  expect(places[6]!.x).toBeLessThan(0)
})

test('eight colours still make fields that can be read, and one sensor a straight row', () => {
  const row = { fields: Array.from({ length: 8 }, () => [0]), now: null, actions }
  expect(fieldSide(row, 1)).toBe(22)
  const places = placesOf(row, 1)
  expect(places.every(({ x }) => x === 0)).toBe(true)
})

test('in a low pane its fields are smaller, so that all of it is seen', () => {
  const room = 150
  const side = fieldSide(fan, 2, room)
  expect(side).toBeLessThan(fieldSide(fan, 2))
  expect(24 + 3 * Math.SQRT2 * side).toBeCloseTo(room)
  expect(fieldSide(fan, 2, 40)).toBe(22)
})

test('the picture of all fields leaves none of them out', () => {
  const { x, y, width } = drawFan(fan, 2).still!
  const half = fieldSide(fan, 2) / Math.SQRT2
  for (const place of placesOf(fan)) {
    expect(place.x - half).toBeGreaterThan(x)
    expect(place.x + half).toBeLessThan(x + width)
    expect(place.y - half).toBeGreaterThan(y)
    expect(place.y + half).toBeLessThan(0)
  }
})

test.each([
  [{ left: 50, right: 50 }, 'M0 8V-8'],
  [{ left: -40, right: -40 }, 'M0-8V8'],
  [{ left: 0, right: 0 }, 'M-5.500'],
  [{ left: 20, right: 60 }, 'M4 8'],
  [{ left: 60, right: 0 }, 'M-5 8'],
])('the arrow of %o', (wheels, begins) => {
  expect(actionSign(wheels).startsWith(begins)).toBe(true)
})
