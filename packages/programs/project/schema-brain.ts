import { activations, type Brain } from '@botgarten/learning/neural-network/brain'
import * as v from 'valibot'
import { examplesSchema, practiceSchema } from './schema-examples.ts'
import { finite, idSchema, recordOf } from './schema-program.ts'

const weights = recordOf(recordOf(finite))
const neuron = v.object({ id: idSchema, activation: v.picklist(activations), bias: finite })

export const brainSchema: v.GenericSchema<unknown, Brain> = v.object({
  kind: v.literal('network'),
  layers: v.array(v.array(neuron)),
  weights,
  sets: recordOf(weights),
  examples: v.exactOptional(examplesSchema),
  practice: v.exactOptional(practiceSchema),
})
