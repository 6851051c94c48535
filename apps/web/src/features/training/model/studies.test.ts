import { noExamples, prepare, beginExercise, withDrive } from '@botgarten/learning/neural-network/examples'
import type { Exercise } from '@botgarten/learning/neural-network/examples'
import { practise, starter } from '@botgarten/learning/neural-network/train'
import { expect, test } from 'vitest'
import { endOf, overSeeds, overSizes, seedsCompared } from './studies.ts'

const neuron = (id: string, activation: 'identity' | 'tanh' = 'identity') => ({ id, activation, bias: 0 })
const layers = [[neuron('a')], ['h1', 'h2'].map((id) => neuron(id, 'tanh')), [neuron('w')]]
const driven = (id: string, from: number) => ({
  drive: { id, by: 'pad' as const, seed: 1, test: id === 'held' },
  rows: Array.from({ length: 12 }, (_, k) => ({
    ...{ tick: 6 * k, pose: { x: k, y: 50, heading: 0 } },
    ...{ inputs: [from + 7 * k], outputs: [60 - 1.2 * (from + 7 * k)] },
  })),
})
const examples = [driven('one', 1), driven('two', 4), driven('held', 2)].reduce(
  (all, { drive, rows }) => withDrive(all, drive, rows).examples,
  noExamples(['a'], ['w']),
)
const exercise: Exercise = {
  ...{ id: 'net', layers, weights: {}, examples, seed: 3, keepBack: 1e-9, from: 'knobs', mirror: null },
}
const settings = { ...starter, rounds: 30 }

function toEnd<Result>(steps: Generator<undefined, Result>): Result {
  for (;;) {
    const { done, value } = steps.next()
    if (done) return value
  }
}

test('every seed practises as it would alone', () => {
  const lines = toEnd(overSeeds(exercise, settings))
  expect(lines.map(({ number }) => number)).toEqual(Array.from({ length: seedsCompared }, (_, k) => 3 + k))
  const own: Exercise = { ...exercise, from: 'zero', seed: 5 }
  expect(lines[2]!.curve).toEqual(practise(beginExercise(prepare(own), settings, own)))
})

test('with more examples the test gets better, and all of them are all of them', () => {
  const lines = toEnd(overSizes(exercise, settings))
  expect(lines.map(({ number }) => number)).toEqual([3, 6, 12, 18, 24])
  // Only the error before practice and the one after all 30 rounds.
  for (const { curve } of lines) expect(curve.map(({ round }) => round)).toEqual([0, 30])
  expect(endOf(lines.at(-1)!, false)).toBeLessThan(endOf(lines[0]!, false))
  const own: Exercise = { ...exercise, from: 'zero' }
  const whole = practise(beginExercise(prepare(own), settings, own)).at(-1)!
  expect(lines.at(-1)!.curve.at(-1)).toEqual(whole)
})
