import { expect, test } from 'vitest'
import { actionFill, actionSign } from './action-signs.ts'
import type { Command, Group } from './commands.ts'
import { drawFan, drawFanNow, fanInSight, fieldSide, roomIn, type Fan } from './fan.ts'
import { turned } from './points.ts'

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

test.each([0, 45, 90, 180, 290])('at an edge, turned by %i, it is moved until all of it is seen', (turn) => {
  const seen = { x: 100, y: 50, width: 400, height: 300 }
  const half = fieldSide(fan, 2, roomIn(seen)) / Math.SQRT2
  for (const at of [
    { x: 110, y: 60 },
    { x: 490, y: 340 },
    { x: 300, y: 55 },
  ]) {
    const to = fanInSight(fan, 2, { at, turn, seen })
    const picture = drawFan(fan, 2, roomIn(seen)).shapes
    for (const one of picture) {
      const place = turned((one as Group).shapes[0] as { x: number; y: number }, turn)
      expect(to.x + place.x).toBeGreaterThan(seen.x + half * 0.7)
      expect(to.x + place.x).toBeLessThan(seen.x + seen.width - half * 0.7)
      expect(to.y + place.y).toBeGreaterThan(seen.y + half * 0.7)
      expect(to.y + place.y).toBeLessThan(seen.y + seen.height - half * 0.7)
    }
  }
})

test('in the middle it stays at its robot, and so it does where the robot is out of sight', () => {
  const seen = { x: 0, y: 0, width: 800, height: 800 }
  for (const at of [
    { x: 400, y: 400 },
    { x: -30, y: 400 },
  ])
    expect(fanInSight(fan, 2, { at, turn: 30, seen })).toEqual(at)
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
  [{ left: 0, right: 0 }, 'M-5.5'],
  [{ left: 20, right: 60 }, 'M4 8'],
  [{ left: 60, right: 0 }, 'M-5 8'],
])('the arrow of %o', (wheels, begins) => {
  expect(actionSign(wheels).startsWith(begins)).toBe(true)
})
