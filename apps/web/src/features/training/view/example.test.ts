import { learner } from '@botgarten/learning/neural-network'
import { rowsOf, starter, type TrainTrace } from '@botgarten/learning/neural-network/train'
import { stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { factorsOf, formulaOf, gradientOf, productOf } from './example.ts'

const neuron = (id: string, activation: 'identity' | 'tanh' | 'relu' = 'identity') => ({
  id,
  activation,
  bias: 0,
})

function traced(hidden: boolean, outputs: number, pair: readonly number[], rate: number): TrainTrace {
  const outs = Array.from({ length: outputs }, (_, k) => neuron(`o${k}`))
  const layers = [[neuron('a'), neuron('b')], ...(hidden ? [[neuron('h', 'tanh')]] : []), outs]
  const weights = {
    a: { h: 0.4, o0: 0.3 },
    b: { h: -0.7, o0: 0.2 },
    h: Object.fromEntries(outs.map(({ id }, k) => [id, 0.5 - 0.3 * k])),
  }
  const targets = outs.map((_, k) => pair[2]! - 7 * k)
  const practised = rowsOf([{ inputs: pair.slice(0, 2), outputs: targets }])
  const data = { layers, weights, practised, kept: rowsOf([]) }
  const practice = learner.begin({ ...starter, rate, order: 'table' }, data, stream(1, 'x'))
  let found: TrainTrace | null = null
  learner.step(practice, (trace) => (found = trace))
  return found!
}

test('the factors of every knob multiply to its arrow', () => {
  const value = fc.double({ min: 0, max: 100, noNaN: true })
  fc.assert(
    fc.property(
      fc.boolean(),
      fc.integer({ min: 1, max: 4 }),
      fc.tuple(value, value, value),
      fc.constantFrom(0.01, 0.1, 0.3),
      (hidden, outputs, pair, rate) => {
        const trace = traced(hidden, outputs, pair, rate)
        for (const { from, to, before, after } of trace.links) {
          if (from === '#bias') continue
          const factors = factorsOf(trace, { rate, batch: 1 }, [from, to], false)
          expect(productOf(factors)).toBeCloseTo(after - before, 12)
        }
      },
    ),
    { seed: 23, numRuns: 60 },
  )
})

test('with two outputs and no slope a step is speed × error × input, as in the picture', () => {
  const trace = traced(false, 2, [80, 100, 70], 0.1)
  const factors = factorsOf(trace, { rate: 0.1, batch: 1 }, ['a', 'o0'], false)
  expect(factors.map(({ name }) => name)).toEqual(['speed', 'error', 'input'])
  expect(factors[2]!.value).toBeCloseTo(0.8, 12)
})

test('experts read the gradient of this example, and the formula of the chosen method', () => {
  const trace = traced(false, 2, [80, 100, 70], 0.1)
  expect(gradientOf(trace, ['a', 'o0'])).toMatch(/^∂L\/∂w = ∂L\/∂z · x = −0[.,]26 · 0[.,]8 = −0[.,]208$/)
  const plain = { optimizer: 'sgd', momentum: 0, decay: 0 } as const
  expect(formulaOf(plain)).toBe('Δw = −η · ∂L/∂w')
  expect(formulaOf({ ...plain, momentum: 0.9, decay: 0.01 })).toBe('v ← μ·v + (∂L/∂w + λ·w), Δw = −η · v')
  expect(formulaOf({ ...plain, optimizer: 'adam' })).toBe('Δw = −η · m̂ ÷ (√v̂ + ε)')
})
