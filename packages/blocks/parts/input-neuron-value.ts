import type { BlockType } from '../packs/packs.ts'
import type { Definition, Pack } from '../types.ts'
import { field } from './fields.ts'
import { rows, value, words } from './looks.ts'
import { ask, done } from './next.ts'
import { numberAt } from './numbers.ts'
import { afterAsking } from './steps.ts'
import { nameField } from './variables.ts'

/** Gives an input of the network its value, until it is set again. */
export const inputNeuronValue = (
  type: BlockType,
  pack: Pack,
  example: Definition['example'],
): Definition => ({
  type,
  pack,
  look: {
    category: 'network',
    shape: 'statement',
    fields: [nameField('neuron', 'n1')],
    inputs: [value('VALUE', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame, context, block) => {
    context.memory.net().inputs[field(block, 'NAME')] = numberAt(frame, 0)
    return done
  }),
  python: (py) => py.line(`${py.neuron('inputs', py.field('NAME'))} = ${py.value('VALUE')}`),
  example,
})
