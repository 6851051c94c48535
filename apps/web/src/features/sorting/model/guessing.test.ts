import { describe, expect, test } from 'vitest'
import { sets, setOf } from '#figures/things/sets.ts'
import { groupsBy, judge, roundsOf } from './guessing.ts'

const vessels = setOf('vessels')

describe('guess the criterion', () => {
  test.each(sets.map((set) => [set.id, set] as const))('every thing of %s lies in one group', (_, set) => {
    for (const { id } of set.features) {
      const groups = groupsBy(set, [id], 3)
      expect(groups.flat().toSorted((a, b) => a - b)).toEqual(set.things.map((_, thing) => thing))
    }
  })

  test('the sorting is shown round by round: everything is in a group in each, and the last is what comes out', () => {
    for (const set of sets)
      for (const { id } of set.features) {
        const rounds = roundsOf(set, [id], 3)
        expect(rounds.at(-1)).toEqual(groupsBy(set, [id], 3))
        for (const round of rounds)
          expect(round.flat().toSorted((a, b) => a - b)).toEqual(set.things.map((_, thing) => thing))
      }
  })

  test('the criterion itself is right, in any order', () => {
    expect(judge(vessels, ['width', 'height'], ['height', 'width'], 3)).toEqual({ kind: 'right' })
  })

  test('what makes other groups is wrong, with what was found of it', () => {
    expect(judge(vessels, ['width', 'height'], ['width', 'colour'], 3)).toEqual({
      kind: 'wrong',
      found: 1,
      of: 2,
    })
  })

  test('what makes the same groups is said to', () => {
    const leaves = setOf('leaves')
    const features = leaves.features.map(({ id }) => id)
    const pairs = features.flatMap((a) =>
      features.map((b) => [[a], [a, b].filter((x, i, all) => all.indexOf(x) === i)]),
    )
    const verdicts = pairs.map(([a, b]) => judge(leaves, a!, b!, 2).kind)
    for (const [index, [a, b]] of pairs.entries()) {
      const same = JSON.stringify(groupsBy(leaves, a!, 2)) === JSON.stringify(groupsBy(leaves, b!, 2))
      expect(verdicts[index]).toBe(a!.length === b!.length ? 'right' : same ? 'alike' : 'wrong')
    }
  })
})
