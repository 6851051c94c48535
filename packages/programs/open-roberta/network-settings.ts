import type { PracticeNote } from '@botgarten/learning/neural-network/brain'
import { starterChoice, withChoice } from '@botgarten/learning/neural-network/examples'
import * as v from 'valibot'

// How a network of today's Open Roberta practises: it says so beside the weights. It keeps no examples.

/** What does not fit is left out, and nothing else for its sake. */
const part = <Schema extends v.GenericSchema>(schema: Schema) => v.fallback(v.nullish(schema), null)

const schema = v.object({
  learningRate: part(v.pipe(v.number(), v.minValue(0.0001), v.maxValue(5))),
  batchSize: part(v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(10_000))),
  regularization: part(v.string()),
  regularizationRate: part(v.pipe(v.number(), v.minValue(0), v.maxValue(1))),
})

/**
 * Learning rate, batch and, with L2, weight decay as settings for the first practice; biases learn too, as they do there. L1 has
 * no counterpart here. Null where nothing of it is said.
 */
export function settingsIn(data: string): PracticeNote | null {
  const { success, output } = v.safeParse(schema, JSON.parse(data))
  if (!success) return null
  const { learningRate, batchSize, regularization, regularizationRate } = output
  const decay = regularization === 'L2' ? regularizationRate : null
  if (learningRate === null && batchSize === null && decay === null) return null
  return withChoice(undefined, {
    ...starterChoice,
    settings: {
      ...starterChoice.settings,
      ...(learningRate && { rate: learningRate }),
      ...(batchSize && { batch: batchSize }),
      ...(decay && { decay }),
      bias: 'on',
    },
  })
}
