import {
  Course,
  gridMap,
  layOutWorld,
  type QMap,
  type Settings,
  type Task,
} from '@botgarten/learning/q-learning'
import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { readMap } from '@botgarten/maps'
import { worldOf } from '@botgarten/maps/zoo'
import { describe, expect, test } from 'vitest'
import { RIDES, ridesOf, tieOn } from './rides.ts'

const settings: Settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 }
const roads = [[1, 5], [0, 2], [1, 3], [2, 4, 5], [3, 5], [0, 3, 4]] // prettier-ignore
const railway: Task = {
  ...{ map: { actions: roads.map((list) => list.map((to) => ({ to }))) }, start: 3, goal: 1 },
}
const courseOn = (task: Task) => new Course(layOutWorld(task), settings, 1, { episodes: 300, steps: 100_000 })

function knows(values: { readonly [road: string]: number }): Course {
  const course = courseOn(railway)
  const { learner } = course
  for (const [road, value] of Object.entries(values)) {
    const action = learner.world.names.indexOf(road)
    learner.q[action] = value
    learner.tries[action] = 1
  }
  learner.goals = 1
  return course
}

describe('what Bo has learned is walked', () => {
  test('a circle three times', () => {
    const [ride] = ridesOf(knows({ '3-4': 20, '4-3': 20 }), 1)
    expect(ride).toEqual({ states: [3, 4, 3, 4, 3, 4, 3], end: 'circle' })
  })

  test('a way that is half learned as far as it goes', () => {
    const [ride] = ridesOf(knows({ '3-5': 20 }), 1)
    expect(ride).toEqual({ states: [3, 5], end: 'stuck' })
  })

  test('on ice ten rides, the same for the same dice; each move leads where the ice allows', () => {
    const course = courseOn(gridMap(['SFFF', 'FHFH', 'FFFH', 'HFFG'], { surefooted: 1 / 3 }))
    course.advance(100_000)
    const rides = ridesOf(course, 5)
    expect(rides).toHaveLength(RIDES)
    expect(ridesOf(course, 5)).toEqual(rides)
    const { world } = course.learner
    for (const { states, end } of rides) {
      expect(end === 'goal').toBe(states.at(-1) === 15)
      for (const [at, to] of states.slice(1).entries()) {
        const from = states[at]!
        const [first, end] = [world.first[from]!, world.first[from + 1]!]
        const ends = Array.from(world.to.subarray(world.outcome[first], world.outcome[end]))
        expect(ends).toContain(to)
      }
    }
  })

  test('where moves may slip, a ride is stuck in a dead end and lost in a hole', () => {
    const endsOf = (actions: QMap['actions'], terminals: readonly number[]) =>
      ridesOf(courseOn({ map: { actions, terminals }, start: 0, goal: 3 }), 1).map(({ states, end }) => [
        states,
        end,
      ])
    const forked = [{ to: 1, slip: 0.5 }, { to: 2 }]
    const [stuck, lost] = [endsOf([forked, [], [], []], []), endsOf([forked, [], [], []], [1, 2])]
    expect(stuck).toHaveLength(RIDES)
    for (const [states, end] of stuck) expect([String(states), end]).toEqual([expect.stringMatching(/^0,[12]$/), 'stuck']) // prettier-ignore
    for (const [states, end] of lost) expect([String(states), end]).toEqual([expect.stringMatching(/^0,[12]$/), 'lost']) // prettier-ignore
  })

  test('on ice a ride that does not arrive ends after a hundred moves', () => {
    // Without practice each state's first move leads west, where only slips lead away from the edge.
    const course = courseOn(gridMap(['SFFF', 'FFFF', 'FFFF', 'FFFG'], { surefooted: 1 / 3 }))
    for (const { states, end } of ridesOf(course, 1)) {
      expect(end).toBe('tired')
      expect(states).toHaveLength(1 + 100)
    }
  })

  test('two moves of the same worth are told, the first on the way', () => {
    const course = knows({ '3-2': 20, '3-5': 20, '2-1': 25, '5-0': 25, '0-1': 30 })
    expect(tieOn(course, [3, 2, 1])).toEqual({ station: 3, to: [2, 5] })
    expect(tieOn(knows({ '3-2': 20, '2-1': 25 }), [3, 2, 1])).toBeNull()
  })

  test('at the fountain both moves are told with a reward of 18, and not with one more or less', () => {
    const { cage } = content.cages.find(({ cage: one }) => one.id === 'fountain')!
    const { map } = readMap(readFileSync(content.mapOfCage('fountain'), 'utf8'))
    const told = [17, 18, 19].map((reward) => {
      const limits = { episodes: 300, steps: 100_000 }
      const course = new Course(worldOf(cage, map!, reward, settings.gamma), settings, 1, limits)
      course.advance(100_000)
      return tieOn(course, [0, 1, 2, 3, 5])
    })
    // Back and forth is worth 18 + 0.8 · 0.8 · 50 = 50, as much as the school.
    expect(told).toEqual([null, { station: 3, to: [2, 5] }, null])
  })
})
