import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { sumOf } from './count.ts'
import { countsTable, csv, rowsOf, sentencesTable } from './csv.ts'
import { growthOf } from './growth.ts'
import { nothingReleased, released } from './release.ts'
import { talliesOf, total, type PaperCounts, type Published } from './tally.ts'
import { answersOf, chanceOf, columns } from './testing/answers.ts'
import type { Answer } from './types.ts'

const answer = (at: number, values: Answer['values'], over: Partial<Answer> = {}): Answer => ({
  id: at.toString(16).padStart(32, '0'),
  ...{ form: 'after', grade: 5, code: null, day: '2026-11-26', values },
  ...over,
})
const publish = (answers: readonly Answer[], paper: readonly PaperCounts[] = []): Published => ({
  ...{ answers, paper },
  release: released(nothingReleased, answers, ['before', 'after'], chanceOf(7)),
})

describe('a table', () => {
  it('counts by grade, and both together', () => {
    const young = Array.from({ length: 5 }, (_, at) => answer(at, { interest: '5' }, { grade: 4 }))
    const older = Array.from({ length: 6 }, (_, at) => answer(10 + at, { interest: '2', 'go-on': 'no' }))
    const tallies = talliesOf('after', columns, publish([...young, ...older]))
    expect(tallies.map(({ bands, n, counts }) => [bands, n, counts['interest']])).toEqual([
      [['3-4'], 5, [0, 0, 0, 0, 5]],
      [['5-6'], 6, [0, 6, 0, 0, 0]],
    ])
    expect(total(tallies)!.counts['interest']).toEqual([0, 6, 0, 0, 5])
    expect(total(tallies)!.counts['go-on']).toEqual([0, 0, 6])
  })

  it('leaves out what fewer than five of a group answered, sentences too', () => {
    const four = { 'go-on': 'yes', 'take-along': 'Bo!' }
    const answers = Array.from({ length: 7 }, (_, at) => answer(at, at < 4 ? four : { interest: '3' }))
    const [only] = talliesOf('after', columns, publish(answers))
    expect([only!.counts['go-on'], only!.open['take-along'], only!.counts['interest']]).toEqual([
      [0, 0, 0],
      [],
      [0, 0, 0, 0, 0],
    ])
  })

  it('adds counts from paper, and none of fewer than five sheets', () => {
    const sheets = (n: number): PaperCounts => ({
      ...{ form: 'after', bands: ['5-6'], n },
      counts: { interest: [0, 0, 0, 1, n - 1], 'go-on': [1, 0, 0] },
      open: { 'take-along': ['One sentence alone'] },
    })
    const answers = Array.from({ length: 5 }, (_, at) => answer(at, { interest: '1' }))
    const [only] = talliesOf('after', columns, publish(answers, [sheets(6), sheets(4)]))
    expect([only!.n, only!.counts['interest']]).toEqual([11, [5, 0, 0, 1, 5]])
    expect([only!.counts['go-on'], only!.open['take-along']]).toEqual([[0, 0, 0], []])
  })

  it('never counts fewer than five people in any item of any group', () => {
    fc.assert(
      fc.property(answersOf(['before', 'after']), (answers) => {
        for (const { n, counts, open } of talliesOf('after', columns, publish(answers))) {
          expect(n).toBeGreaterThanOrEqual(5)
          const sizes = [
            ...Object.values(counts).map(sumOf),
            ...Object.values(open).map(({ length }) => length),
          ]
          for (const size of sizes) expect(size === 0 || size >= 5).toBe(true)
        }
      }),
    )
  })
})

describe('CSV', () => {
  const answers = Array.from({ length: 6 }, (_, at) =>
    answer(at, { interest: '4', robot: 'right', 'take-along': '=1+1, "so"' }, { code: `owl-10${at}` }),
  )
  const published = publish(answers)
  const tallies = talliesOf('after', columns, published)

  it('holds a row a child without code and day', () => {
    const text = csv(rowsOf('after', columns, tallies, published, chanceOf(3)))
    expect(text).toBe(`\uFEFFgrades,interest,go-on,robot\r\n${'5-6,4,,right\r\n'.repeat(6)}`)
  })

  it('keeps sentences apart, and takes no formula', () => {
    const text = csv(sentencesTable('take-along', total(tallies), chanceOf(3)))
    expect(text.split('\r\n')[1]).toBe(`"'=1+1, ""so"""`)
  })

  it('counts an option a row', () => {
    expect(countsTable(columns, tallies)).toContainEqual(['5-6', 6, 'interest', '4', 6])
  })
})

describe('growth', () => {
  it('compares what the same children guessed right before and after', () => {
    const side = (form: string, from: number, right: number) =>
      Array.from({ length: 6 }, (_, at) =>
        answer(from + at, { robot: at < right ? 'right' : 'left' }, { form, code: `owl-10${at}` }),
      )
    const { answers, release } = publish([...side('before', 0, 1), ...side('after', 50, 5)])
    const growth = growthOf(release.comparisons[0]!, columns, columns, answers)!
    expect([growth.n, growth.of]).toEqual([6, 1])
    // Four rose, none fell: 2 / 2^4.
    expect(growth.test).toMatchObject({ n: 4, plus: 10, minus: 0, p: 0.125, r: 1 })
  })

  it('is nothing where the forms ask no question in common', () => {
    const none = columns.filter(({ kind }) => kind !== 'robot')
    expect(growthOf({ before: 'before', after: 'after', pairs: [] }, none, columns, [])).toBeNull()
  })
})

describe('groups', () => {
  it('are in the order of their grades, also where paper was added to one of them', () => {
    const young = Array.from({ length: 5 }, (_, at) => answer(at, { interest: '5' }, { grade: 3 }))
    const older = Array.from({ length: 5 }, (_, at) => answer(10 + at, { interest: '2' }))
    const paper: PaperCounts = {
      ...{ form: 'after', bands: ['3-4'], n: 5, open: {} },
      counts: { interest: [0, 0, 5, 0, 0] },
    }
    const tallies = talliesOf('after', columns, publish([...young, ...older], [paper]))
    expect(tallies.map(({ bands, n }) => [bands, n])).toEqual([
      [['3-4'], 10],
      [['5-6'], 5],
    ])
    expect(countsTable(columns, tallies)[0]).toEqual(['grades', 'people', 'item', 'option', 'count'])
  })
})
