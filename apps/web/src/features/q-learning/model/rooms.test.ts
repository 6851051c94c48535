import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { gridMap, layOutWorld } from '@botgarten/learning/q-learning'
import { readMap } from '@botgarten/maps'
import { expect, test } from 'vitest'
import { endsOf, roomsOf, roomSize } from './rooms.ts'

test('where ice may lead, and what that brings: equal ends are one', () => {
  const world = layOutWorld(gridMap(['SF', 'FG'], { surefooted: 1 / 3 }))
  const q = Float64Array.from(world.names, () => 10)
  const from = (name: string) => endsOf(world, q, world.names.indexOf(name), 0.8)
  // From the corner, left and up lead nowhere.
  expect(from('0-left')).toEqual([
    { to: 0, odds: expect.closeTo(2 / 3, 12) as number, brings: 8 },
    { to: 2, odds: expect.closeTo(1 / 3, 12) as number, brings: 8 },
  ])
  // Beside the goal, whose reward is 50: behind it there is nothing more.
  expect(from('1-down').map(({ to, brings }) => [to, brings])).toEqual([
    [0, 8],
    [3, 50],
    [1, 8],
  ])
})

test('each action of a room is a triangle on the side to which it leads, with its tip in the middle', () => {
  const map = readMap(readFileSync(content.path('maps', 'cliff', 'map.svg'), 'utf8')).map!
  const world = layOutWorld({ map: map.map, start: map.start!, goal: map.goal! })
  const rooms = roomsOf(world, map)
  expect(rooms.length).toBeGreaterThan(10)
  const ways = { left: [-1, 0], right: [1, 0], up: [0, -1], down: [0, 1] }
  for (const { state, x, y, triangles } of rooms) {
    const own = world.names.flatMap((_, action) => (world.from[action] === state ? [action] : []))
    expect(triangles.map(({ action }) => action)).toEqual(own)
    for (const { side, path } of triangles) {
      const [ax, ay, tipX, tipY, bx, by] = path.match(/-?[\d.]+/g)!.map(Number) as [number, number, number, number, number, number] // prettier-ignore
      expect([tipX, tipY]).toEqual([x, y])
      // Half of the base is as long as the triangle is high: four of them are a square.
      const half = Math.hypot(bx - ax, by - ay) / 2
      expect([(ax + bx) / 2 - x, (ay + by) / 2 - y]).toEqual(
        ways[side].map((way) => expect.closeTo(way * half, 9) as number),
      )
      expect(half).toBeGreaterThan(0)
      expect(half).toBeLessThan(roomSize(map) / 2)
    }
  }
})
