import type { Template } from '../types.ts'

export const start: Template = {
  type: 'robControls_start',
  mutation: { attrs: { declare: 'false' } },
  fields: { DEBUG: 'FALSE' },
}

export const number = (value: number): Template => ({
  type: 'math_number',
  shadow: true,
  fields: { NUM: String(value) },
})
export const text = (value: string): Template => ({ type: 'text', shadow: true, fields: { TEXT: value } })

export const show = (out: Template, row = 0): Template => ({
  type: 'robActions_display_text',
  values: { OUT: out, COL: number(0), ROW: number(row) },
})

export const forever = (...blocks: readonly Template[]): Template => ({
  type: 'robControls_loopForever',
  statements: { DO: blocks },
})

/** Green lamp while the condition holds, else red. */
export const lampIf = (condition: Template): Template => ({
  type: 'robControls_ifElse',
  mutation: { attrs: { else: '1' } },
  values: { IF0: condition },
  statements: {
    DO0: [{ type: 'actions_bricklight_on_ev3', fields: { COLOUR: 'GREEN', MODE: 'ON' } }],
    ELSE: [{ type: 'actions_bricklight_on_ev3', fields: { COLOUR: 'RED', MODE: 'ON' } }],
  },
})

const list = (listType: 'InputNode' | 'OutputNode', neurons: readonly Template[]): Template => ({
  type: 'ai_easy_list',
  mutation: { attrs: { items: String(neurons.length), list_type: listType } },
  values: Object.fromEntries(neurons.map((neuron, k) => [`ADD${k}`, neuron])),
})

/** `hidden`: layers between them, from the inputs on. */
export const network = (
  inputs: readonly Template[],
  outputs: readonly Template[],
  ...hidden: readonly Template[]
): Template => ({
  type: 'ai_neural_network',
  values: {
    INPUT_LAYER: hidden.reduce(
      (before, layer) => ({ ...layer, values: { LAYER: before } }),
      list('InputNode', inputs),
    ),
    OUTPUT_LAYER: list('OutputNode', outputs),
  },
})

export const hiddenLayer = (neurons: number, activation = 'RELU'): Template => ({
  type: 'ai_nn_hidden_layer',
  fields: { NEURONS: String(neurons), ACTIVATION: activation },
})

export const distanceNeuron = (port: string): Template => ({
  type: 'ai_nn_input_node_ultrasonic',
  fields: { INPUTNODE: `ULTRASONIC_PORT_${port}` },
})
export const motorNeuron = (port: string): Template => ({
  type: 'ai_nn_output_node',
  fields: { OUTPUTNODE: `MOTORPORT_${port}` },
})

/** Start, then forever a net of these neurons. */
export const netProgram = (
  inputs: readonly Template[],
  outputs: readonly Template[],
  ...hidden: readonly Template[]
): readonly Template[] => [start, forever(network(inputs, outputs, ...hidden))]
