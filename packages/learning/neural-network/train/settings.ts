import type { ObjectSchema } from '../../parameters.ts'
import type { Settings } from './types.ts'

/** What practice takes; everything else is refused. */
export const parameters: ObjectSchema = {
  type: 'object',
  properties: {
    rate: { type: 'number', minimum: 0.0001, maximum: 5 },
    momentum: { type: 'number', minimum: 0, maximum: 0.999 },
    optimizer: { enum: ['sgd', 'adam'] },
    decay: { type: 'number', minimum: 0, maximum: 1 },
    batch: { type: 'integer', minimum: 1, maximum: 10_000 },
    rounds: { type: 'integer', minimum: 1, maximum: 100_000 },
    bias: { enum: ['on', 'off'] },
    range: { enum: ['free', 'unit'] },
    order: { enum: ['shuffled', 'table'] },
    patience: { type: 'integer', minimum: 0, maximum: 100_000 },
  },
  required: [
    ...['rate', 'momentum', 'optimizer', 'decay', 'batch', 'rounds'],
    ...['bias', 'range', 'order', 'patience'],
  ],
  additionalProperties: false,
}

/** One example a step, no momentum and no bias: an arrow in the picture is the step itself. */
export const starter: Settings = {
  ...{ rate: 0.1, momentum: 0, optimizer: 'sgd', decay: 0, batch: 1, rounds: 60 },
  ...{ bias: 'off', range: 'free', order: 'shuffled', patience: 0 },
}
