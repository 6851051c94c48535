import content from 'content:questionnaires'
import { bands } from '@botgarten/answers'
import { expect, test } from 'vitest'
import { gradesOf, scaleBlocks, slopesOf, studyOf } from './results.ts'

const after = content.forms.find(({ form }) => form.id === 'after')!
const tally = (counts: { readonly [item: string]: readonly number[] }) => ({
  bands: ['5-6'] as const,
  n: 22,
  counts,
  open: {},
})

test('a class of grades 5 and 6 stands beside the seven children of 2020', () => {
  const [interest, ease] = scaleBlocks(after, tally({ 'interest-supervised': [0, 1, 3, 8, 10] }))
  const [supervised, unsupervised] = interest!.rows
  expect([supervised!.n, supervised!.median, supervised!.study]).toEqual([22, 4, 4.57])
  expect(supervised!.mean).toBeCloseTo(4.227, 3)
  expect([unsupervised!.counts, unsupervised!.mean, unsupervised!.study]).toEqual([null, null, 4.14])
  expect(ease!.rows.map(({ study }) => study)).toEqual([4.28, 4.14, 3.42])
})

test('mixed grades have no group of 2020, nor have the oldest', () => {
  expect(studyOf({ ...tally({}), bands: ['3-4', '5-6'] })).toBeUndefined()
  expect(studyOf({ ...tally({}), bands: ['10-12'] })).toBeUndefined()
  expect(bands.slice(0, 3).map((band) => studyOf({ ...tally({}), bands: [band] })!.n)).toEqual([10, 7, 7])
})

test('grades are said from the first to the last', () => {
  expect([gradesOf(['5-6']), gradesOf(['3-4', '5-6'])]).toEqual(['5–6', '3–6'])
  expect(gradesOf(['10-12'])).toBe('10–12')
})

test('a topic has a line of the shares that guessed right, and none where no form asked it', () => {
  const before = content.forms.find(({ form }) => form.id === 'before')!
  const item = before.form.items.find((one) => one.kind === 'robot')!
  const { question } = content.asked.find((one) => one.question.id === item.question)!
  // 3 of 4 guessed right.
  const counts = question.choices.map((choice, at) =>
    choice === question.answer ? 3 : at === (question.choices[0] === question.answer ? 1 : 0) ? 1 : 0,
  )
  const source = {
    ...{ forms: [before], isOpen: () => false, count: () => 22, growths: () => [], close: () => {} },
    ...{ tallies: () => [tally({ [item.id]: counts })], rows: () => Promise.resolve([]) },
  }
  expect(slopesOf(source, [before])).toEqual([{ topic: item.topic, points: [{ at: 0, share: 0.75, n: 4 }] }])
  expect(slopesOf({ ...source, isOpen: () => true }, [before])).toEqual([])
})
