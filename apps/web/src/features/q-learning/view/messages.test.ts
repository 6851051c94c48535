import { Course, gridMap, layOutWorld, type Settings, type Task } from '@botgarten/learning/q-learning'
import { describe, expect, test } from 'vitest'
import { m } from '#words/message.ts'
import { shownOf } from '../model/shown.ts'
import type { Level } from '../model/choices.svelte.ts'
import type { Learning } from '../model/learning.svelte.ts'
import { endOf, placesOf, reasonOf } from './messages.ts'

const preset: Settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0, rho: 0.5 }
const roads = [[1, 5], [0, 2], [1, 3], [2, 4, 5], [3, 5], [0, 3, 4]] // prettier-ignore
const railway: Task = {
  ...{ map: { actions: roads.map((list) => list.map((to) => ({ to }))) }, start: 3, goal: 1 },
}

function courseOf(task: Task, episodes: number, settings: Partial<Settings> = {}) {
  const course = new Course(layOutWorld(task), { ...preset, ...settings }, 1, { episodes, steps: 1e6 })
  course.advance(1e6)
  return course
}
const reason = (course: Course, shortest: number | null = 2, level?: Level) =>
  reasonOf({ shown: shownOf(course), shortest }, level)

describe('why there is no way yet is said', () => {
  test('after one try: where all roads are still alike, and no try is named in which it was found', () => {
    const course = courseOf(railway, 1)
    expect(reason(course)).toBe(m['q.alike']({ station: 3 }))
    expect(shownOf(course)).toMatchObject({ found: null, foundAt: null })
  })

  test('after many tries: nothing, and the try in which it was found is named', () => {
    const course = courseOf(railway, 100)
    expect(reason(course)).toBe('')
    expect(shownOf(course).way.states).toEqual([3, 2, 1])
    expect(shownOf(course).found).toBeGreaterThan(1)
  })

  test('by the rules of the study with the way that the first of equal roads gives, and that it is not learned', () => {
    // Nothing is learned with α = 0; every road has been tried.
    const course = courseOf(railway, 500, { rules: 'study', nu: 0.9, rho: 0.9, alpha: 0 })
    expect(reason(course)).toBe(
      `${m['q.alike']({ station: 3 })} ${m['q.firstOfEqual']({ way: '3 → 2 → 1' })}`,
    )
  })

  test('of a road that was never tried where all others cost', () => {
    const course = courseOf({ ...railway, stepCost: 1, goalReward: 0 }, 2, { rho: 0 })
    expect([m['q.untried'], m['q.unknown']].map((say) => say({ station: 3 }))).toContain(reason(course))
  })

  test('if every road to the goal is closed: that there is no way, and at the end that it was not found', () => {
    const open = (from: number, to: number) => ![from, to].includes(1)
    const actions = roads.map((list, from) => list.filter((to) => open(from, to)).map((to) => ({ to })))
    const course = courseOf({ ...railway, map: { actions } }, 10)
    expect(reason(course, null)).toBe(m['q.noWay']())
    const learning = { shown: shownOf(course), state: 'over', outline: { episodes: 10 } }
    expect(endOf(learning as unknown as Learning)).toBe(
      `${m['q.byEpisodes']({ count: 10 })} ${m['q.notYet']()}`,
    )
  })

  describe('of a circle', () => {
    const actions = [[{ to: 1 }, { to: 2 }], [{ to: 0 }], [{ to: 3 }], [{ to: 4 }], []]
    const learned = (paid: number, episodes: number) =>
      courseOf({ map: { actions, rewards: { 1: paid } }, start: 0, goal: 4 }, episodes, {
        ...{ gamma: 0.9, rho: 0.9 },
      })
    const endAfter = (course: Course, episodes: number) =>
      endOf({ shown: shownOf(course), state: 'over', outline: { episodes } } as unknown as Learning)

    test('that pays more than the goal: it is learned, and more tries change nothing', () => {
      const course = learned(60, 300)
      expect(reason(course)).toBe(m['q.circlePays']({ circle: '0 → 1 → 0' }))
      expect(endAfter(course, 300)).toBe(`${m['q.byEpisodes']({ count: 300 })} ${m['q.circleEnd']()}`)
    })

    test('that pays less: the way is not learned yet', () => {
      // After one episode the value of the goal has not come as far as the start.
      const course = learned(4, 1)
      const { way, isCircleBest } = shownOf(course)
      expect({ way: way.reason, isCircleBest }).toEqual({ way: 'circle', isCircleBest: false })
      expect(reason(course)).toBe(m['q.circle']({ station: 0, circle: '0 → 1 → 0' }))
      expect(endAfter(course, 1)).toBe(`${m['q.byEpisodes']({ count: 1 })} ${m['q.notYet']()}`)
    })
  })
})

test('on the slippery lake what Bo would do is judged by what it is worth: no circle is spoken of', () => {
  const { map, start, goal } = gridMap(['SFFF', 'FHFH', 'FFFH', 'HFFG'], { surefooted: 1 / 3 })
  const settings: Partial<Settings> = {
    alpha: 1,
    gamma: 0.95,
    nu: 0.5,
    rho: 1,
    alphaDecay: { kind: 'visits' },
  }
  const course = courseOf({ map, start, goal, goalReward: 1 }, 100_000, settings)
  const { plan, way } = shownOf(course)
  expect(way).toMatchObject({ states: null, reason: 'chance' })
  // Gymnasium's FrozenLake-v1 with γ = 0.95: value iteration gives 0.1805, and 32 of 41 rides get to the goal.
  expect(plan!.best).toBeCloseTo(0.180471578397, 9)
  const chance = m['q.chance']({ rides: '78' })
  expect(reason(course, 6)).toBe(`${chance} ${m['q.chanceWorth']({ value: '0.18', best: '0.18' })}`)
  expect(reason(course, 6, 'starter')).toBe(chance)
})

test('where the goal pays a single star, as on the lake, values are said to a hundredth', () => {
  const paying = (goalReward?: number) =>
    layOutWorld({ ...railway, ...(goalReward !== undefined && { goalReward }) })
  expect([paying(), paying(0), paying(1)].map((world) => placesOf('explorer', world))).toEqual([0, 0, 2])
  expect(placesOf('expert', paying(1))).toBe(3)
})
