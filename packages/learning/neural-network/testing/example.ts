import type { Example } from '../../testing/contract.ts'
import { rowsOf } from '../train/rows.ts'
import { starter } from '../train/settings.ts'

const neuron = (id: string, activation: 'identity' | 'tanh' | 'relu') => ({ id, activation, bias: 0 })
const pairs = Array.from({ length: 12 }, (_, at) => ({
  inputs: [(at * 37) % 101, (at * 53) % 101],
  outputs: [(at * 29) % 101, 50 - ((at * 41) % 101)],
}))

/** 2-3-2, with batches that do not fit the examples, so that steps of every kind come up. */
export const example: Example = {
  parameters: { ...starter, bias: 'on', momentum: 0.5, batch: 5, rounds: 8, patience: 3 },
  data: {
    layers: [
      [neuron('l', 'identity'), neuron('r', 'identity')],
      [neuron('h#1', 'tanh'), neuron('h#2', 'tanh'), neuron('h#3', 'tanh')],
      [neuron('m', 'identity'), neuron('n', 'identity')],
    ],
    weights: {
      l: { 'h#1': 0.3, 'h#2': -0.2 },
      r: { 'h#2': 0.4, 'h#3': 0.1 },
      'h#1': { m: 0.5 },
      'h#3': { n: 0.2 },
    },
    practised: rowsOf(pairs.slice(0, 9)),
    kept: rowsOf(pairs.slice(9)),
  },
  steps: 80,
}
