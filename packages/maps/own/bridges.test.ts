import { expect, test } from 'vitest'
import { bridgesOf } from './bridges.ts'
import { addRoad, addStation, emptyMap } from './edit.ts'
import { bendPiece, faultsOf, lineOf } from './line.ts'

const drawn = (places: readonly (readonly [x: number, y: number])[], roads: readonly (readonly [number, number])[]) =>
  roads.reduce((map, [from, to]) => addRoad(map, from, to), places.map(([x, y]) => ({ x, y })).reduce(addStation, emptyMap('drawn'))) // prettier-ignore
const linesOf = (map: ReturnType<typeof drawn>) => map.roads.map((road) => lineOf(map, road).there)

test('where two roads cross the later one leads over the other, near the crossing alone', () => {
  const map = drawn([[200, 200], [800, 800], [200, 800], [800, 200]], [[0, 1], [2, 3]]) // prettier-ignore
  const [bridge, ...others] = bridgesOf(linesOf(map))
  expect(others).toEqual([])
  expect(bridge).toMatchObject({ upper: 1, lower: 0 })
  const points = bridge!.line.split(/[ML]/).slice(1).map((point) => point.split(' ').map(Number)) // prettier-ignore
  for (const [x, y] of points) expect(Math.hypot(x! - 500, y! - 500)).toBeLessThan(46)
})

test('roads that meet at a station have no bridge there', () => {
  const map = drawn([[200, 200], [800, 800], [800, 200]], [[0, 1], [1, 2], [0, 2]]) // prettier-ignore
  expect(bridgesOf(linesOf(map))).toEqual([])
})

test('a bend that is too tight is the piece of the road that is marked', () => {
  const straight = drawn([[200, 500], [900, 500]], [[0, 1]]) // prettier-ignore
  const bends = [{ x: 500, y: 500 }, { x: 540, y: 560 }, { x: 580, y: 500 }] // prettier-ignore
  const map = { ...straight, roads: [{ ...straight.roads[0]!, bends }] }
  const [fault] = faultsOf(map)
  expect(fault).toMatchObject({ kind: 'tight' })
  const piece = bendPiece(map, map.roads[0]!, (fault as { bend: number }).bend)
  expect(lineOf(map, map.roads[0]!).there).toContain(piece.slice(1))
})
