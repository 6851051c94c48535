import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { readMap, type MapFile } from '@botgarten/maps'
import { learnIn, type Cage } from '@botgarten/maps/zoo'
import { describe, expect, test } from 'vitest'
import { reasonAt } from './reason.ts'
import { MOST_MOVES, watch } from './watched.ts'

/** A line of four stations, 0 to the goal 3 and back; each visit of station 2 is paid. */
const line = {
  map: { actions: [[{ to: 1 }], [{ to: 0 }, { to: 2 }], [{ to: 1 }, { to: 3 }], [{ to: 2 }]] },
} as unknown as MapFile
const cage: Cage = {
  ...{ id: 'line', start: 0, goal: 3, wish: {}, solution: 0, why: { at: 2, to: 3 } },
  pay: [
    { for: 'station', station: 2, reward: 20 },
    { for: 'goal', reward: 50 },
  ],
  mend: { rule: 0, least: 0, most: 30, step: 10 },
  claim: { aLot: 'never', aLittle: 'wish' },
  setting: { alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5, episodes: 100 },
  source: { by: '', year: 2016, title: '', in: '' },
}

describe('the reason of a decision', () => {
  test('is what both moves pay at once, and 80 % of what the best way brings then', () => {
    const { at, moves } = reasonAt(cage, line, 30)!
    const [meant, other] = moves
    expect(at).toBe(2)
    expect(meant).toEqual({ to: 3, pays: 50, then: 0, sum: 50, isBest: false })
    // Back and forth: V(1) = 30 + 0.8 · V(2), V(2) = 0.8 · V(1), so V(1) = 30 / (1 − 0.64) = 83.3.
    expect(other).toMatchObject({ to: 1, pays: 0, isBest: true })
    expect(other.then).toBeCloseTo(30 / 0.36, 6)
    expect(other.sum).toBeCloseTo((0.8 * 30) / 0.36, 6)
  })

  test('speaks for the mission where the pay is right', () => {
    // 50 at once is more than 0.8 · 20 / 0.36 = 44.4.
    expect(reasonAt(cage, line, 20)!.moves.map(({ isBest }) => isBest)).toEqual([true, false])
  })

  test('speaks for both moves where they are worth the same', () => {
    // 0.8 · 22.5 / 0.36 = 50, as much as at once.
    const { moves } = reasonAt(cage, line, 22.5)!
    expect(moves.map(({ isBest }) => isBest)).toEqual([true, true])
    expect(moves[1].sum).toBeCloseTo(50, 9)
  })

  test('compares with the best of the other moves', () => {
    // Station 1 leads back, to a station that pays nothing, and to the one before the goal.
    const fork = {
      map: { actions: [[{ to: 1 }], [{ to: 0 }, { to: 2 }, { to: 3 }], [{ to: 1 }], [{ to: 4 }], []] },
    } as unknown as MapFile
    const forked: Cage = { ...cage, goal: 4, pay: [{ for: 'goal', reward: 50 }], mend: { rule: 0, least: 0, most: 50, step: 1 }, why: { at: 1, to: 2 } } // prettier-ignore
    const { moves } = reasonAt(forked, fork, 50)!
    expect(moves.map(({ to, isBest }) => [to, isBest])).toEqual([
      [2, false],
      [3, true],
    ])
    // The same with stations 0 and 3 in each other's place: a station is worth the same under any number.
    const swapped = {
      map: { actions: [[{ to: 4 }], [{ to: 0 }, { to: 2 }, { to: 3 }], [{ to: 1 }], [{ to: 1 }], []] },
    } as unknown as MapFile
    expect(
      reasonAt({ ...forked, start: 3 }, swapped, 50)!.moves.map(({ to, isBest }) => [to, isBest]),
    ).toEqual([
      [2, false],
      [0, true],
    ])
  })

  test('is none where the cage names no station', () => {
    const { why: _, ...without } = cage
    expect(reasonAt(without, line, 20)).toBeNull()
  })

  test.each(content.cages.filter(({ cage }) => cage.why))(
    'in the cage $cage.id is against the mission until the pay is right',
    ({ cage }) => {
      const { map } = readMap(readFileSync(content.mapOfCage(cage.id), 'utf8'))
      const [meant, other] = reasonAt(cage, map!, cage.solution)!.moves
      expect([meant.isBest, other.sum < meant.sum]).toEqual([true, true])
    },
  )
})

describe('the robot that is watched', () => {
  test('earns what its moves pay, and comes to the goal once', () => {
    const { steps, reward, goals, outcome, setting, learnedIn } = watch(learnIn(cage, line, 10, 1), 10)
    expect(steps).toEqual([
      { from: 0, to: 1, reward: 0 },
      { from: 1, to: 2, reward: 10 },
      { from: 2, to: 3, reward: 50 },
    ])
    expect([reward, goals, outcome, setting]).toEqual([60, 1, 'wish', 10])
    expect(learnedIn).toBeGreaterThan(100)
  })

  test('is watched for 100 moves where it never ends', () => {
    const { steps, goals, reward } = watch(learnIn(cage, line, 30, 1), 30)
    expect([steps.length, goals]).toEqual([MOST_MOVES, 0])
    // Every second move leads to station 2.
    expect(reward).toBe((MOST_MOVES / 2) * 30)
  })
})
