import { cardConfig, type Obstacle, type Pose, type Shape, type World } from '@botgarten/simulation'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  cornerOf,
  freshId,
  itemOf,
  moved,
  poseOf,
  put,
  sized,
  stretched,
  toFloor,
  toOwn,
  wallBetween,
  withColour,
  withItem,
  without,
  type Item,
} from './edits.ts'

const pose: Pose = { x: 100, y: 50, heading: 0 }
const crate: Obstacle = {
  ...{ id: 'crate', shape: { kind: 'rectangle', width: 30, height: 20 }, pose },
  ...{ fixed: false, colour: '#DDB27C', look: 'crate' },
}
const line = { id: 'line', points: [{ x: 0, y: 0 }, { x: 20, y: 10 }], width: 2, colour: '#000000' } // prettier-ignore
const area = (id: string) => ({ id, shape: { kind: 'circle', radius: 5 }, pose, colour: '#0057A6' }) as const
const world: World = {
  size: { width: 300, height: 200 },
  floor: { colour: '#FFFFFF' },
  areas: [area('a'), area('b'), area('c')],
  lines: [line],
  obstacles: [crate],
  robots: [{ id: 'bo', pose, program: 'main', brain: '', config: cardConfig }],
}
const item = (id: string): Item => itemOf(world, id)!

describe('items of a world', () => {
  test('are found by their name, changed, added and taken away; the rest stays the same object', () => {
    expect(itemOf(world, 'nobody')).toBeNull()
    expect(itemOf(world, null)).toBeNull()
    const changed = withItem(world, put(item('b'), { ...pose, x: 7 }))
    expect(changed.areas[1]!.pose.x).toBe(7)
    expect(changed.areas[0]).toBe(world.areas[0])
    expect(withItem(world, { kind: 'areas', thing: area('d') }).areas.map(({ id }) => id)).toEqual([
      'a',
      'b',
      'c',
      'd',
    ])
    expect(without(world, item('b')).areas.map(({ id }) => id)).toEqual(['a', 'c'])
  })

  test('go up and down among their like, not beyond the ends', () => {
    const order = (next: World) => next.areas.map(({ id }) => id).join('')
    expect(order(moved(world, item('b'), 1))).toBe('acb')
    expect(order(moved(world, item('b'), -1))).toBe('bac')
    expect(moved(world, item('a'), -1)).toBe(world)
    expect(moved(world, item('c'), 1)).toBe(world)
  })

  test('a new one gets a name that nobody has', () => {
    const taken = withItem(world, { kind: 'areas', thing: area('areas1') })
    expect(freshId(taken, 'areas')).toBe('areas2')
    expect(freshId(taken, 'lines')).toBe('lines1')
  })

  test('in another colour a crate becomes a plain thing: else nobody would see it', () => {
    expect(withColour(item('crate'), '#B30006').thing).not.toHaveProperty('look')
    expect(withColour(item('line'), '#B30006').thing.colour).toBe('#B30006')
  })
})

test('a line is moved and turned about its middle', () => {
  expect(poseOf(item('line'))).toEqual({ x: 10, y: 5, heading: 0 })
  expect(put(item('line'), { x: 110, y: 5, heading: 0 }).thing).toMatchObject({
    points: [{ x: 100, y: 0 }, { x: 120, y: 10 }], // prettier-ignore
  })
  expect(put(item('line'), { x: 10, y: 5, heading: 90 }).thing).toMatchObject({
    points: [{ x: 15, y: -5 }, { x: 5, y: 15 }], // prettier-ignore
  })
})

describe('sizes', () => {
  const shapes: readonly Shape[] = [
    { kind: 'rectangle', width: 30, height: 20 },
    { kind: 'triangle', width: 30, height: 20, tip: 10 },
    { kind: 'circle', radius: 10 },
  ]

  test.each(shapes)('a $kind that is pulled by its corner has it where the hand is', (shape) => {
    fc.assert(
      fc.property(fc.integer({ min: 1, max: 200 }), fc.integer({ min: 1, max: 200 }), (x, y) => {
        const next = stretched(shape, { x, y: -y })
        const corner = cornerOf(next)
        if (shape.kind !== 'circle') expect(corner).toEqual({ x, y: -y })
        else expect(Math.abs(Math.hypot(corner.x, corner.y) - Math.hypot(x, y))).toBeLessThanOrEqual(0.25)
      }),
    )
  })

  test('nothing becomes smaller than 1 cm or longer than 10 m', () => {
    expect(sized(shapes[0]!, 0, 1e9)).toEqual({ kind: 'rectangle', width: 1, height: 1000 })
    expect(stretched(shapes[2]!, { x: 0, y: 0 })).toEqual({ kind: 'circle', radius: 1 })
  })

  test('a triangle keeps its form', () => {
    expect(sized(shapes[1]!, 60, 20)).toEqual({ kind: 'triangle', width: 60, height: 20, tip: 20 })
  })
})

test('the frame of a thing and back is the same point', () => {
  const number = fc.integer({ min: -300, max: 300 })
  fc.assert(
    fc.property(number, number, number, (x, y, heading) => {
      const back = toFloor({ ...pose, heading }, toOwn({ ...pose, heading }, { x, y }))
      expect(back.x).toBeCloseTo(x, 6)
      expect(back.y).toBeCloseTo(y, 6)
    }),
  )
})

test('a wall goes from point to point, and a little further, so that corners close', () => {
  const wall = wallBetween('w', { x: 0, y: 10 }, { x: 0, y: 110 })
  expect(wall).toMatchObject({ pose: { x: 0, y: 60, heading: 90 }, fixed: true, look: 'wall' })
  expect(wall.shape).toEqual({ kind: 'rectangle', width: 106, height: 6 })
})
