import fc from 'fast-check'
import { expect, test } from 'vitest'
import { gridMap, layOutWorld, lengthOf, shortestLength, shortestPath } from './index.ts'

const roads = fc.array(
  fc.record({
    from: fc.nat(5),
    to: fc.nat(5),
    length: fc.integer({ min: 1, max: 50 }),
  }),
  { maxLength: 20 },
)

/** Every way of at most six states, one after the other. */
function shortestOfAll(moves: readonly (readonly { readonly to: number; readonly length: number }[])[]) {
  let least = Infinity
  const walk = (at: number, walked: number, seen: readonly number[]): void => {
    if (at === 5) least = Math.min(least, walked)
    else
      for (const { to, length } of moves[at]!)
        if (!seen.includes(to)) walk(to, walked + length, [...seen, to])
  }
  walk(0, 0, [0])
  return least === Infinity ? null : least
}

test('the shortest length is the least of all ways', () => {
  fc.assert(
    fc.property(roads, (list) => {
      const moves = Array.from({ length: 6 }, (_, from) => {
        const own = list.filter((road) => road.from === from && road.to !== from)
        return own.filter(({ to }, index) => own.findIndex((road) => road.to === to) === index)
      })
      const world = layOutWorld({ map: { actions: moves }, start: 0, goal: 5 })
      expect(shortestLength(world)).toBe(shortestOfAll(moves))
    }),
    { seed: 1, numRuns: 300 },
  )
})

test('a way is as long as its roads, and a closed road is none', () => {
  const moves = [[{ to: 1, length: 3 }], [{ to: 2, length: 4 }], []]
  const world = layOutWorld({ map: { actions: moves }, start: 0, goal: 2 })
  expect(lengthOf(world, [0, 1, 2])).toBe(7)
  expect(() => lengthOf(world, [0, 2])).toThrow('No open road leads from 0 to 2.')
  const closed = layOutWorld({ map: { actions: moves }, start: 0, goal: 2, closed: [[1, 2]] })
  expect(() => lengthOf(closed, [0, 1, 2])).toThrow('No open road leads from 1 to 2.')
  expect(shortestLength(closed)).toBeNull()
})

test('a step off the cliff leads back: the shortest way goes round it, 13 steps; in the wind it has 15 (example 6.5)', () => {
  const cliff = gridMap(['FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'SCCCCCCCCCCG'], {
    cliffReward: -99,
  })
  expect(shortestPath(layOutWorld(cliff))).toBe(14)
  const rows = ['F', 'F', 'F', 'S', 'F', 'F', 'F'].map((first, row) =>
    row === 3 ? 'SFFFFFFGFF' : first.repeat(10),
  )
  expect(shortestPath(layOutWorld(gridMap(rows, { wind: [0, 0, 0, 1, 1, 1, 2, 2, 1, 0] })))).toBe(16)
})
