import { stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { Course, createLearner, layOutWorld, run, saveLearner, starsOf, step, visited } from './index.ts'
import type { Settings } from './types.ts'

const roads = [
  [1, 5],
  [0, 2],
  [1, 3],
  [2, 4, 5],
  [3, 5],
  [0, 3, 4],
]
const map = { actions: roads.map((list) => list.map((to) => ({ to }))) }
const world = layOutWorld({ map, start: 3, goal: 1, closed: [[3, 2], [2, 3]] }) // prettier-ignore
const settings: Settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 }

const course = (seed = 1, episodes = 1e6, steps = 1e6) =>
  new Course(world, settings, seed, { episodes, steps })
const alone = (seed = 1) => createLearner(world, settings, stream(seed, 'learn/playground'))

describe('a course', () => {
  test('learns what the learner learns, in whatever slices', () => {
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 1, max: 700 }), { maxLength: 12 }), (slices) => {
        const one = course()
        for (const slice of slices) one.advance(slice)
        const other = alone()
        run(other, one.shown)
        expect(saveLearner(one.learner)).toEqual(saveLearner(other))
      }),
      { seed: 1, numRuns: 30 },
    )
  })

  test('shows every move again as it was, and goes on from it the same', () => {
    fc.assert(
      fc.property(fc.integer({ min: 1, max: 6000 }), fc.nat(6000), (made, wanted) => {
        const one = course(3)
        one.advance(made)
        const { episodes } = one
        const kept = [...episodes]
        one.goTo(wanted)
        const at = Math.min(wanted, made)
        const other = alone(3)
        run(other, at - 1)
        expect(one.trace).toEqual(at > 0 ? step(other) : null)
        expect(saveLearner(one.learner)).toEqual(saveLearner(other))
        one.advance(made - at)
        expect(one.made).toBe(made)
        expect(one.episodes).toEqual(kept)
      }),
      { seed: 2, numRuns: 60 },
    )
  })

  test('goes on being exact when kept states lie further apart', () => {
    const one = course(5)
    one.advance(450_000)
    one.goTo(333_333)
    const other = alone(5)
    run(other, 333_333)
    expect([...one.learner.q]).toEqual([...other.q])
  })

  test('opens the last move, whatever stopped it', () => {
    for (const [moves, episodes] of [
      [77, 1e6],
      [100_000, 10],
      [1, 1],
    ] as const) {
      const one = course(4, episodes)
      one.next()
      one.advance(moves)
      expect(one.trace?.t).toBe(one.shown)
    }
  })

  test('says which limit stopped it', () => {
    const few = course(1, 20)
    few.advance(100_000)
    expect([few.over, few.episodes.length]).toEqual(['episodes', 20])
    const short = course(1, 1000, 10)
    expect(short.advance(100)).toBe(10)
    expect([short.over, short.next()]).toEqual(['steps', null])
  })

  test('writes down each episode: moves, reward, and whether the goal was reached', () => {
    const one = course(2, 50)
    one.advance(100_000)
    expect(one.episodes).toHaveLength(50)
    expect(one.episodes.reduce((sum, { steps }) => sum + steps, 0)).toBe(one.made)
    for (const { atGoal, reward } of one.episodes) expect(reward).toBe(atGoal ? 50 : 0)
    expect(one.episodes.at(-1)!.best).toBe(3)
  })

  test('knows in which episode the way was found, also when one looks back', () => {
    const one = course(2, 50)
    one.advance(100_000)
    const found = one.foundIn()!
    expect(one.episodes[found - 2]?.best ?? null).not.toBe(3)
    for (const { best } of one.episodes.slice(found - 1)) expect(best).toBe(3)
    expect(one.foundAt()).toBe(one.episodes.slice(0, found).reduce((sum, { steps }) => sum + steps, 0))
    one.goTo(1)
    expect(one.foundIn()).toBeNull()
  })

  test('says of no other way that it was found then: within an episode the learned way may change', () => {
    fc.assert(
      fc.property(fc.nat(50), (seed) => {
        const one = course(seed, 30)
        const found = new Map<number, string>()
        while (one.next()) {
          const way = one.way().states?.join('-')
          const episode = one.foundIn()
          if (episode === null) continue
          expect(found.get(episode) ?? way).toBe(way)
          found.set(episode, way!)
        }
      }),
      { seed: 3, numRuns: 50 },
    )
  })
})

test('stars compare with what the goal pays: half of it is not all of it, and what has paid has half of one', () => {
  const stars = (value: number, highest = 0) => starsOf({ world, q: Float64Array.of(0, highest) }, value)
  expect([0, 0.2, 5, 25, 50].map((value) => stars(value, 25))).toEqual([0, 0.5, 0.5, 2.5, 5])
  expect(stars(-3)).toBe(0)
})

test('where more is paid than at the goal, stars compare with the highest value', () => {
  const stars = [50, 125, 250].map((value) => starsOf({ world, q: Float64Array.of(250) }, value))
  expect(stars).toEqual([1, 2.5, 5])
})

test('stations that it has been to are known by their roads', () => {
  const one = course(1)
  expect(visited(one.learner)).toEqual([false, false, false, false, false, false])
  one.next()
  const seen = visited(one.learner)
  expect(seen.filter(Boolean).length).toBeGreaterThanOrEqual(2)
  expect(seen[one.trace!.to]).toBe(true)
})
