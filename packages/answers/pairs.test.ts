import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { Atom } from './atoms.ts'
import { pairsOf, publishable, split, type Pair } from './pairs.ts'
import { chanceOf } from './testing/answers.ts'
import { fewest, type Answer } from './types.ts'

const ids = (form: string, count: number) => Array.from({ length: count }, (_, at) => `${form}-${at}`)
const atom = (form: string, count: number): Atom => ({ form, bands: ['5-6'], ids: ids(form, count) })
/** `count` pupils who answered both forms. */
const pairs = (count: number): readonly Pair[] =>
  Array.from({ length: count }, (_, at): Pair => [`before-${at}`, `after-${at}`])

describe('pairs that can be published', () => {
  it('are exactly five where four have to be left out beside one without a pair', () => {
    // Of 10 answers 9 have a pair: the others become 1 + 4 = 5, and 9 − 4 = 5 pairs are left.
    const found = publishable(pairs(9), [atom('before', 10), atom('after', 14)], chanceOf(1))
    expect(found).toHaveLength(5)
    expect(publishable(pairs(8), [atom('before', 9), atom('after', 13)], chanceOf(1))).toEqual([])
  })

  it('are all of them where five or none have no pair, and none where there are only four', () => {
    expect(publishable(pairs(5), [atom('before', 5), atom('after', 5)], chanceOf(1))).toHaveLength(5)
    expect(publishable(pairs(5), [atom('before', 10), atom('after', 5)], chanceOf(1))).toHaveLength(5)
    expect(publishable(pairs(4), [atom('before', 5), atom('after', 5)], chanceOf(1))).toEqual([])
  })

  const counts = (least: number) =>
    fc
      .record({
        both: fc.nat(30),
        before: fc.integer({ min: least, max: 12 }),
        after: fc.integer({ min: least, max: 12 }),
      })
      .filter(({ both, before, after }) => both + Math.min(before, after) >= fewest)

  it('split every group into pieces of none or at least five', () => {
    fc.assert(
      fc.property(counts(0), fc.integer(), ({ both, before, after }, seed) => {
        const atoms = [atom('before', both + before), atom('after', both + after)]
        const found = publishable(pairs(both), atoms, chanceOf(seed))
        for (const { ids } of split(atoms, found)) expect(ids.length).toBeGreaterThanOrEqual(fewest)
      }),
    )
  })

  it('are as many as possible: only so many are left out that each form has five without a pair', () => {
    fc.assert(
      fc.property(counts(1), fc.integer(), ({ both, before, after }, seed) => {
        const atoms = [atom('before', both + before), atom('after', both + after)]
        const left = both - Math.max(0, fewest - before, fewest - after)
        expect(publishable(pairs(both), atoms, chanceOf(seed)).length).toBe(left < fewest ? 0 : left)
      }),
    )
  })
})

describe('a pupil', () => {
  const answer = (id: string, code: string | null): Answer => ({
    ...{ id, form: id.split('-')[0]!, grade: 5, code, day: '2026-11-26', values: {} },
  })

  it('is found in two forms by the code; a code that is there twice, or is missing, finds nobody', () => {
    const before = [answer('before-1', 'owl-1'), answer('before-2', 'owl-2'), answer('before-3', null)]
    const after = [
      ...[answer('after-1', 'owl-1'), answer('after-2', 'owl-2')],
      ...[answer('after-3', 'owl-2'), answer('after-4', null)],
    ]
    expect(pairsOf(before, after)).toEqual([['before-1', 'after-1']])
  })
})
