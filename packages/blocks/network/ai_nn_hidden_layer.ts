import { part } from '../parts/python.ts'
import { distanceNeuron, hiddenLayer, motorNeuron, netProgram } from '../parts/examples.ts'
import { hiddenType as type, mostInLayer, mostNeurons, wantedNeurons } from '../parts/layers.ts'
import { choice, rows, words, worded } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import { filledRows, plugged } from '../parts/rows.ts'
import type { Block, Definition } from '../types.ts'

const activation = choice('ACTIVATION', [
  worded('RELU', 'relu'),
  worded('SIGMOID', 'sigmoid'),
  worded('TANH', 'tanh'),
  worded('THRESHOLD', 'threshold'),
  worded('LINEAR', 'linear'),
])

const layer = ask('LAYER')

/** How many neurons stand between the world and this layer: the first layer that does not fit any more says so. */
function neuronsBefore(block: Block): number {
  const before = plugged(block, 'LAYER')
  if (!before) return 0
  return before.type === type ? wantedNeurons(before) + neuronsBefore(before) : filledRows(before).length
}

/**
 * Neurons between the inputs and the outputs. The layer before stands in it; it hands that layer's values on, since the
 * network's brain computes its neurons (running.md 11).
 */
export const ai_nn_hidden_layer: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'network',
    shape: 'value',
    output: 'InputLayer',
    fields: [{ name: 'NEURONS', kind: 'number', preset: 3, min: 1, max: mostInLayer, step: 1 }, activation],
    inputs: [{ name: 'LAYER', kind: 'value', accepts: ['InputLayer'], optional: true }],
    layer: 'hidden',
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  check(block) {
    const own = wantedNeurons(block)
    if (own > mostInLayer)
      return [{ problem: 'problem.tooManyInLayer', facts: { count: own, most: mostInLayer }, stops: true }]
    const before = neuronsBefore(block)
    const facts = { count: before + own, most: mostNeurons }
    return before <= mostNeurons && before + own > mostNeurons
      ? [{ problem: 'problem.tooManyNeurons', facts, stops: true }]
      : []
  },
  run(block, frame) {
    if (frame.stage++ === 0 && plugged(block, 'LAYER')) return layer
    return give(frame.got.at(-1) ?? [])
  },
  python: part,
  example: netProgram(
    [distanceNeuron('2'), distanceNeuron('3')],
    [motorNeuron('C'), motorNeuron('B')],
    hiddenLayer(3),
  ),
}
