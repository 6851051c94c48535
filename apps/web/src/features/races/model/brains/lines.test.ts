import type { LaneKind, Racer } from '@botgarten/experiments/brain-race'
import type { Summary } from '@botgarten/experiments/brain-race/table'
import { expect, test } from 'vitest'
import { linesOf } from './lines.ts'

interface Driven {
  readonly score?: number
  readonly bumps?: number
  readonly parts?: number
  readonly effort?: Racer['effort'] | null
  readonly examples?: number
}

const summary = (
  kind: LaneKind,
  { score = 900, bumps = 0, parts = 2, effort, examples }: Driven,
): Summary => ({
  ...{ kind, score, cm: score, atWall: 0, bumps, decisions: 10 },
  bill: {
    parts,
    examples: examples === undefined ? null : { on: examples, aside: 0, seconds: 9 },
    practised: examples === undefined ? null : { rounds: 60, examples },
    ...{ tried: null, effort: effort ?? null },
  },
})

const line = (summaries: readonly (Summary | null)[], id: string) =>
  linesOf(summaries, { kind: 'way' }).find((one) => one.id === id)!

test('the best of each line is marked, several where they are equal, and none where one lane alone has a number', () => {
  const driven = [
    summary('hand', { score: 862, bumps: 9 }),
    summary('examples', { score: 995, parts: 22, examples: 600 }),
    null,
    summary('ifThen', { score: 896, parts: 18 }),
  ]
  expect(line(driven, 'score')).toEqual({ id: 'score', values: [862, 995, null, 896], best: [1] })
  expect(line(driven, 'bumps').best).toEqual([1, 3])
  expect(line(driven, 'parts').best).toEqual([0])
  expect(line(driven, 'examples')).toEqual({ id: 'examples', values: [null, 600, null, null], best: [] })
})

test('tries are moves of knobs, rounds, or runs; no lane wins them', () => {
  const effort = { knobs: 14, starts: 9, bumps: 5, hand: 360, computer: 0.3 }
  const driven = [
    summary('hand', { effort }),
    summary('examples', { effort, examples: 600 }),
    summary('ifThen', { effort: { ...effort, hand: 90 } }),
    summary('ifThen', {}),
  ]
  expect(line(driven, 'tries')).toEqual({
    id: 'tries',
    values: [14, 60, 9, null],
    units: ['knobs', 'rounds', 'starts', null],
    best: [],
  })
  expect(line(driven, 'hand')).toEqual({ id: 'hand', values: [6, 6, 1.5, null], best: [2] })
  expect(line(driven, 'computer').values).toEqual([0, 0.3, 0, 0])
  expect(line(driven, 'learningBumps').values).toEqual([5, 5, 5, null])
})

test('of a ready-made brain is said what is known, and no time of a child', () => {
  const driven = [
    summary('hand', { effort: { knobs: 2 } }),
    summary('examples', { effort: { bumps: 0, computer: 0.4 }, examples: 475 }),
    summary('trying', { effort: { bumps: 18, computer: 2.5 } }),
  ]
  expect(line(driven, 'tries').values).toEqual([2, 60, null])
  expect(line(driven, 'learningBumps').values).toEqual([null, 0, 18])
  expect(line(driven, 'hand').values).toEqual([null, null, null])
  expect(line(driven, 'computer').values).toEqual([0, 0.4, 2.5])
})

test('of a time less is better', () => {
  const driven = [summary('hand', { score: 20 }), summary('ifThen', { score: 60 })]
  const [score] = linesOf(driven, { kind: 'time', obstacle: 'square', cm: 10 })
  expect(score!.best).toEqual([0])
})
