import type { World } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { drawFloor, drawGround, drawStations } from './floor.ts'

const world: World = {
  id: 'test',
  size: { width: 200, height: 120 },
  floor: { colour: '#FFEEAA' },
  areas: [
    {
      id: 'a',
      pose: { x: 40, y: 20, heading: 90 },
      shape: { kind: 'rectangle', width: 30, height: 10 },
      colour: '#0057A6',
    },
  ],
  lines: [
    {
      id: 'l',
      points: [
        { x: 0, y: 0 },
        { x: 50, y: 120 },
      ],
      width: 3,
      colour: '#B30006',
    },
  ],
  obstacles: [],
  robots: [],
} as unknown as World

test('the ground has the colour of the floor, white where a picture lies on it', () => {
  expect(drawGround(world)).toMatchObject([{ width: 200, height: 120, fill: '#FFEEAA' }])
  expect(drawGround({ ...world, floor: { image: 'map' } } as unknown as World)).toMatchObject([
    { fill: '#FFFFFF' },
  ])
})

test('areas and lines lie where the world has them, y up becoming y down', () => {
  const [area, line] = drawFloor(world, 2, true)
  expect(area).toMatchObject({ x: 40, y: 100, turn: -90, shapes: [{ x: -15, y: -5, width: 30, height: 10 }] })
  expect(line).toMatchObject({
    points: [
      { x: 0, y: 120 },
      { x: 50, y: 0 },
    ],
    lineWidth: 3,
  })
})

test('the frame is as wide in px whatever the scale', () => {
  const widths = [1, 4].map((scale) =>
    drawFloor(world, scale, true)
      .slice(2)
      .map((shape) => ('lineWidth' in shape ? shape.lineWidth! * scale : 0)),
  )
  expect(widths[0]).toEqual([9, 2, 2])
  expect(widths[1]).toEqual([9, 2, 2])
})

test('a floor without a picture has a dot every half metre', () => {
  expect(drawFloor(world, 1, false).length - drawFloor(world, 1, true).length).toBe(4 * 2)
})

test('stations bear their numbers on the floor, y down, and can be read from far away', () => {
  const [first, second] = drawStations(
    [
      { x: 10, y: 20 },
      { x: 30, y: 40 },
    ],
    100,
    1,
  )
  expect(first).toMatchObject({ x: 10, y: 80, shapes: [{ r: 11 }, {}, { text: '0' }] })
  expect(second).toMatchObject({ x: 30, y: 60, shapes: [{}, {}, { text: '1' }] })
  expect(drawStations([{ x: 0, y: 0 }], 100, 4)[0]).toMatchObject({ shapes: [{ r: 5.5 }, {}, {}] })
})
