import type { Helpers } from '../helpers.ts'

/** The parts of a neural network on plain lists. */
export const network: Helpers = {
  total: () => [
    '(inputs, weights):',
    'result = 0',
    'for value, weight in zip(inputs, weights):',
    '    result += value * weight',
    'return result',
  ],
  layer: ({ call }) => [
    '(inputs, weights, biases):',
    'sums = []',
    'for row, bias in zip(weights, biases):',
    `    sums.append(${call('total')}(inputs, row) + bias)`,
    'return sums',
  ],
  relu: () => ['(value):', 'return max(0, value)'],
  threshold: () => ['(value):', 'return 100 if value > 0 else 0'],
  sigmoid: ({ math }) => ['(value):', `return 100 / (1 + ${math('exp')}(-value / 100))`],
  tanh: ({ math }) => [
    '(value):',
    `grown = ${math('exp')}(value / 50)`,
    'return 100 * (grown - 1) / (grown + 1)',
  ],
  softmax: ({ math }) => [
    '(values):',
    `grown = [${math('exp')}((value - max(values)) / 100) for value in values]`,
    'return [100 * one / sum(grown) for one in grown]',
  ],
  highest: () => [
    '(choices):',
    'best, chosen = 0, None',
    'for level, what in choices:',
    '    if level > best:',
    '        best, chosen = level, what',
    'return chosen',
  ],
}
