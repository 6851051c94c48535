import { distanceNeuron, motorNeuron, netProgram } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { executeOrders } from '../parts/orders.ts'
import { inputListOf } from '../parts/layers.ts'
import { filledRows, plugged } from '../parts/rows.ts'
import type { Block, Definition, Frame, InputLook, Next, Value } from '../types.ts'

const type = 'ai_neural_network'
const inputLayer = ask('INPUT_LAYER')

const layer = (name: string, accepts: 'InputLayer' | 'OutputLayer'): InputLook => ({
  name,
  kind: 'value',
  accepts: [accepts],
  optional: true,
})

const isEmpty = (list: Block | undefined) => !list || filledRows(list).length === 0

const isList = (value: Value | undefined): value is readonly Value[] => Array.isArray(value)

const askOutputs = (given: readonly number[]): Next => ({ next: 'value', input: 'OUTPUT_LAYER', given })

/** The last value is the list that was asked for last. */
function lastList(frame: Frame): readonly Value[] {
  const value = frame.got.at(-1)
  return isList(value) ? value : []
}

export const ai_neural_network: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'network',
    shape: 'statement',
    icon: 'network',
    fields: [],
    inputs: [layer('INPUT_LAYER', 'InputLayer'), layer('OUTPUT_LAYER', 'OutputLayer')],
    rows: rows(type, 5),
  },
  words: words(type),
  acts: true,
  check(block) {
    if (isEmpty(inputListOf(block))) return [{ problem: 'problem.noInputs', stops: true }]
    return isEmpty(plugged(block, 'OUTPUT_LAYER')) ? [{ problem: 'problem.noOutputs', stops: true }] : []
  },
  /** Stages: 0 reads the inputs, 1 thinks and turns the outputs into orders, 2 carries them out. */
  run(block, frame, context) {
    if (frame.stage === 0 && plugged(block, 'INPUT_LAYER')) {
      frame.stage = 1
      return inputLayer
    }
    if (frame.stage < 2 && plugged(block, 'OUTPUT_LAYER')) {
      frame.stage = 2
      return askOutputs(context.think(block.id, lastList(frame) as readonly number[]))
    }
    executeOrders(lastList(frame), context.robot)
    return done
  },
  python: (py) => py.network(),
  example: netProgram([distanceNeuron('2'), distanceNeuron('3')], [motorNeuron('C'), motorNeuron('B')]),
}
