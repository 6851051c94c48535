import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { atomsOf } from './atoms.ts'
import { nothingReleased, released, type Release } from './release.ts'
import { answersOf, chanceOf } from './testing/answers.ts'
import type { Answer } from './types.ts'

const forms = ['before', 'after', 'four-weeks']

const answer = (at: number, over: Partial<Answer> = {}): Answer => ({
  id: at.toString(16).padStart(32, '0'),
  ...{ form: 'after', grade: 5, code: null, day: '2026-11-26', values: {} },
  ...over,
})
const many = (from: number, count: number, over: Partial<Answer> = {}) =>
  Array.from({ length: count }, (_, at) => answer(from + at, over))

const sizes = ({ batches }: Release) => batches.map(({ ids }) => ids.length)

describe('what is published', () => {
  it('is nothing of four, and all of five', () => {
    expect(sizes(released(nothingReleased, many(0, 4), forms, chanceOf(1)))).toEqual([])
    expect(sizes(released(nothingReleased, many(0, 5), forms, chanceOf(1)))).toEqual([5])
  })

  it('grows once five more have come', () => {
    const first = released(nothingReleased, many(0, 7), forms, chanceOf(1))
    const four = released(first, many(0, 11), forms, chanceOf(1))
    expect(sizes(four)).toEqual([7])
    expect(sizes(released(four, many(0, 12), forms, chanceOf(1)))).toEqual([7, 5])
  })

  it('joins a grade with fewer than five to its smaller neighbour', () => {
    const answers = [...many(0, 6, { grade: 3 }), ...many(10, 2, { grade: 6 }), ...many(20, 9, { grade: 8 })]
    const found = atomsOf('after', answers)
    expect(found.map(({ bands, ids }) => [bands, ids.length])).toEqual([
      [['3-4', '5-6'], 8],
      [['7-9'], 9],
    ])
  })

  it('compares a child with itself by its code, where five pairs can be told from nobody', () => {
    const codes = ['robin-101', 'robin-102', 'robin-103', 'robin-104', 'robin-105', 'robin-106']
    const side = (form: string, from: number) => codes.map((code, at) => answer(from + at, { form, code }))
    const all = [...side('before', 0), ...side('after', 100)]
    expect(released(nothingReleased, all, forms, chanceOf(1)).comparisons[0]!.pairs).toHaveLength(6)
    // One child more without a code would be told by subtracting: so four pairs are left out, and no five are left.
    const more = [...all, answer(200, { form: 'before' })]
    expect(released(nothingReleased, more, forms, chanceOf(1)).comparisons).toEqual([])
    const enough = [...all, ...many(200, 5, { form: 'before' })]
    expect(released(nothingReleased, enough, forms, chanceOf(1)).comparisons[0]!.pairs).toHaveLength(6)
  })

  it('takes no code that stands in a form twice', () => {
    const codes = [101, 102, 103, 104, 105, 105]
    const side = (form: string, from: number) =>
      codes.map((code, at) => answer(from + at, { form, code: `owl-${code}` }))
    const { comparisons } = released(
      nothingReleased,
      [...side('before', 0), ...side('after', 50)],
      forms,
      chanceOf(1),
    )
    expect(comparisons).toEqual([])
  })

  /** Every group of people of whom numbers were ever published, by the ids of their answers. */
  const publishedBy = ({ batches, comparisons }: Release) => [
    ...batches.map(({ ids }) => ids),
    ...comparisons.flatMap(({ pairs }) => [pairs.map(([one]) => one), pairs.map(([, other]) => other)]),
  ]

  it('never lets tables be subtracted to fewer than five people, also when more come later', () => {
    const waves = fc.array(answersOf(forms), { minLength: 1, maxLength: 4 })
    fc.assert(
      fc.property(waves, fc.integer(), (given, seed) => {
        const chance = chanceOf(seed)
        let [release, answers] = [nothingReleased, [] as readonly Answer[]]
        const groups: (readonly string[])[] = []
        for (const wave of given) {
          answers = [...answers, ...wave.filter(({ id }) => !answers.some((one) => one.id === id))]
          release = released(release, answers, forms, chance)
          groups.push(...publishedBy(release))
          const { atoms } = release
          for (const { ids } of atoms) expect(ids.length).toBeGreaterThanOrEqual(5)
          // Whatever was published counts each atom as a whole or not at all: so does every sum and difference of it.
          for (const group of groups) {
            const inside = new Set(group)
            for (const { ids } of atoms)
              expect([0, ids.length]).toContain(ids.filter((id) => inside.has(id)).length)
          }
        }
      }),
    )
  })
})
