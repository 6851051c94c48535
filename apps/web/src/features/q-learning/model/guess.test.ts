import { layOutWorld, type QWorld } from '@botgarten/learning/q-learning'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { compare, nextStations, reachesGoal, tapped } from './guess.ts'

/** The forest of the card, with the road between 4 and 6 closed. */
const roads = [[0, 1], [0, 2], [1, 4], [1, 8], [2, 3], [2, 8], [3, 4], [3, 5], [4, 6], [5, 6], [5, 7], [6, 7], [8, 9]] // prettier-ignore
const actions = Array.from({ length: 10 }, (_, from) =>
  roads.flatMap(([a, b]) => (a === from ? [{ to: b! }] : b === from ? [{ to: a! }] : [])),
)
const forest: QWorld = layOutWorld({ map: { actions }, start: 0, goal: 7, closed: [[4, 6], [6, 4]] }) // prettier-ignore

const after = (...taps: readonly number[]) =>
  taps.reduce<readonly number[]>((guess, station) => tapped(forest, guess, station), [0])

test('only neighbours over open roads go on, the closed road does not', () => {
  expect(nextStations(forest, [0])).toEqual([1, 2])
  expect(nextStations(forest, [0, 1, 4])).toEqual([3])
  expect(after(1, 4, 6)).toEqual([0, 1, 4])
  expect(after(7)).toEqual([0])
  expect(after(1, 8, 9)).toEqual([0, 1, 8, 9])
  expect(nextStations(forest, [0, 1, 8, 9])).toEqual([])
})

test('a tap on its own end takes it back, the start stays', () => {
  expect(after(1, 4, 4)).toEqual([0, 1])
  expect(after(0)).toEqual([0])
})

test('at the goal the guess is done, and nothing goes on from it', () => {
  const guess = after(1, 4, 3, 5, 7)
  expect(guess).toEqual([0, 1, 4, 3, 5, 7])
  expect(reachesGoal(forest, guess)).toBe(true)
  expect(nextStations(forest, guess)).toEqual([])
  expect(reachesGoal(forest, [0, 1])).toBe(false)
})

test('whatever is tapped, every step of a guess is an open road, and no station comes twice', () => {
  fc.assert(
    fc.property(fc.array(fc.integer({ min: 0, max: 9 }), { maxLength: 60 }), (taps) => {
      const guess = after(...taps)
      expect(guess[0]).toBe(0)
      expect(new Set(guess).size).toBe(guess.length)
      guess.slice(1).forEach((to, at) => expect(nextStations(forest, guess.slice(0, at + 1))).toContain(to))
    }),
  )
})

test('a guess and the way that came out: how many roads more, where they part, where they meet', () => {
  const way = [0, 2, 3, 5, 7]
  expect(compare([0, 1, 4, 3, 5, 7], way)).toEqual({ more: 1, parting: 0, common: [3, 5, 7] })
  expect(compare(way, way)).toEqual({ more: 0, parting: null, common: [] })
  expect(compare([3, 4, 5, 0, 1], [3, 5, 0, 1])).toEqual({ more: 1, parting: 3, common: [5, 0, 1] })
  expect(compare([0, 2, 8], [0, 1, 8])).toEqual({ more: 0, parting: 0, common: [] })
})
