import { blockFrom, nothing, type Block, type Template } from '@botgarten/blocks'
import {
  biasOf,
  emptyBrain,
  follow,
  hiddenId,
  weightOf,
  weightsOf,
  type Brain,
} from '@botgarten/learning/neural-network/brain'
import { networks } from '../networks.ts'
import type { NetworkOutline, NeuronOutline, Program, Project } from '../types.ts'
import { dataFrom, networkIn } from './network-json.ts'

/** Why a network cannot be said in the blocks of today's Open Roberta. */
export type Unsaid = 'severalNetworks' | 'curved' | 'tone' | 'noStart'

/**
 * The program with its network as today's Open Roberta has it: the weights in the start block's data, and around
 * `robActions_NNstep` blocks that set the inputs and execute the outputs (semantics.md, rules 15 and 38); or why that
 * cannot be. `set`: the robot's weights, by name.
 */
export function inSteps(program: Program, brains: Project['brains'], set = ''): Program | Unsaid {
  const [net, ...others] = networks(program)
  const start = program.stacks.map(({ blocks }) => blocks[0]).find(isStart)
  if (!net || !start) return 'noStart'
  if (others.length > 0 || hasSteps(program)) return 'severalNetworks'
  if (net.outputs.some(({ type }) => type === 'ai_nn_output_node_sound')) return 'tone'
  const brain = brainOf(net, brains)
  const behind = brain.layers.slice(1).flat()
  if (behind.some(({ activation }) => activation !== 'identity')) return 'curved'
  const data = dataFrom(named(brain, set))
  const freshId = freshIds(program)
  const steps = stepsOf(net).map((template) => blockFrom(template, freshId))
  const change = (blocks: readonly Block[]): Block[] =>
    blocks.flatMap((block) =>
      block.id === net.id ? steps : [within(block === start ? { ...block, data } : block, change)],
    )
  return { ...program, stacks: program.stacks.map((stack) => ({ ...stack, blocks: change(stack.blocks) })) }
}

const isStart = (block: Block | undefined): block is Block =>
  block?.type === 'robControls_start' && block.disabled !== true

/** Does the program have a network of Open Roberta's already? The start block keeps one alone. */
const hasSteps = ({ stacks }: Program): boolean => {
  const all = stacks.flatMap(({ blocks }) => blocks)
  return (
    JSON.stringify(all).includes('"robActions_NNstep"') ||
    all.some(({ data }) => data !== undefined && (networkIn(data)?.layers.flat().length ?? 0) > 0)
  )
}

function within(block: Block, change: (blocks: readonly Block[]) => Block[]): Block {
  const { statements } = block
  if (!statements) return block
  const rows = Object.entries(statements).map(([name, row]) => [name, change(row)] as const)
  return { ...block, statements: Object.fromEntries(rows) }
}

function freshIds(program: Program): () => string {
  const text = JSON.stringify(program)
  let number = 0
  return () => {
    for (;;) {
      const id = `step${++number}`
      if (!text.includes(`"${id}"`)) return id
    }
  }
}

/** The brain with the neurons that the blocks say, as the lab computes it. */
function brainOf({ id, inputs, hidden, outputs }: NetworkOutline, brains: Project['brains']): Brain {
  const brain = Object.hasOwn(brains, id) ? brains[id]! : emptyBrain
  const ids = (neurons: readonly NeuronOutline[]) => neurons.map((neuron) => neuron.id)
  const between = hidden.map((layer) =>
    Array.from({ length: layer.neurons }, (_, k) => ({
      id: hiddenId(layer.id, k + 1),
      activation: layer.activation,
    })),
  )
  return follow(brain, ids(inputs), ...between, ids(outputs))
}

const inputName = (k: number) => `i${k + 1}`
const outputName = (k: number) => `o${k + 1}`

/** The same network under Open Roberta's names, with the weights and biases of a set. */
function named(brain: Brain, set: string): Brain {
  const { layers } = brain
  const from = weightsOf(brain, set)
  const last = layers.length - 1
  const name = (layer: number, k: number) =>
    layer === 0 ? inputName(k) : layer === last ? outputName(k) : `h${layer}n${k + 1}`
  const weights = layers.slice(0, -1).flatMap((neurons, layer) =>
    neurons.map((neuron, k) => {
      const row = layers[layer + 1]!.map((to, at) => [name(layer + 1, at), weightOf(from, neuron.id, to.id)])
      return [name(layer, k), Object.fromEntries(row)] as const
    }),
  )
  return {
    kind: 'network',
    layers: layers.map((neurons, layer) =>
      neurons.map((neuron, k) => ({
        ...{ id: name(layer, k), activation: neuron.activation },
        bias: layer === 0 ? 0 : biasOf(from, neuron),
      })),
    ),
    weights: Object.fromEntries<Brain['weights'][string]>(weights),
    sets: {},
  }
}

// ---- blocks ----

const number = (value: number): Template => ({ type: 'math_number', fields: { NUM: String(value) } })
const text = (TEXT: string): Template => ({ type: 'text', fields: { TEXT } })
const output = (k: number): Template => ({
  type: 'robSensors_get_outputneuron_val',
  fields: { NAME: outputName(k) },
})
const compare = (OP: string, A: Template, B: Template, range = 'NUM'): Template => ({
  type: 'logic_compare',
  mutation: { attrs: { operator_range: range } },
  fields: { OP },
  values: { A, B },
})
const both = (A: Template, B: Template): Template => ({
  ...{ type: 'logic_operation', fields: { OP: 'AND' } },
  values: { A, B },
})
const calculate = (OP: string, A: Template, B: Template): Template => ({
  ...{ type: 'math_arithmetic', fields: { OP } },
  values: { A, B },
})
const sensor = (kind: string, mode: string, port: string): Template => ({
  type: `robSensors_${kind}_getSample`,
  mutation: { attrs: { mode } },
  fields: { MODE: mode, SENSORPORT: port, SLOT: '' },
})
/** The first of the ways whose condition holds, else the last. */
const choose = (ways: readonly (readonly [Template, Template])[], otherwise: Template): Template => ({
  type: 'robControls_ifElse',
  mutation: { attrs: { ...(ways.length > 1 && { elseif: String(ways.length - 1) }), else: '1' } },
  values: Object.fromEntries(ways.map(([condition], k) => [`IF${k}`, condition])),
  statements: Object.fromEntries([
    ...ways.map(([, way], k) => [`DO${k}`, [way]] as const),
    ['ELSE', [otherwise]] as const,
  ]),
})

function stepsOf({ inputs, outputs }: NetworkOutline): readonly Template[] {
  return [
    ...inputs.map((neuron, k) => ({
      ...{ type: 'robActions_set_inputneuron_val', fields: { NAME: inputName(k) } },
      values: { VALUE: levelOf(neuron) },
    })),
    { type: 'robActions_NNstep' },
    ...outputs.flatMap(motorSteps),
    ...outputs
      .filter(({ type }) => type === 'ai_nn_output_node_text')
      .map((neuron, row) => wordStep(neuron, row, outputs.indexOf(neuron))),
    ...lampSteps(outputs),
  ]
}

const channels = ['#FF0000', '#00FF00', '#0000FF']

/** What a neuron reads, as 0..100. */
function levelOf({ type, fields }: NeuronOutline): Template {
  const port = fields['SENSORPORT'] ?? '1'
  switch (type) {
    case 'ai_nn_input_node_ultrasonic': {
      const distance = sensor('ultrasonic', 'DISTANCE', fields['INPUTNODE']?.at(-1) ?? '2')
      return { type: 'math_constrain', values: { VALUE: distance, LOW: number(0), HIGH: number(100) } }
    }
    case 'ai_nn_input_node_coloursensor_color': {
      const picked: Template = {
        type: 'robColour_picker',
        fields: { COLOUR: (fields['COLOUR'] ?? '#00642E').toLowerCase() },
      }
      const seen = compare('EQ', sensor('colour', 'COLOUR', port), picked, 'COLOUR')
      return { type: 'logic_ternary', values: { IF: seen, THEN: number(100), ELSE: number(0) } }
    }
    case 'ai_nn_input_node_coloursensor_rgb_channel': {
      const at = Math.max(0, channels.indexOf((fields['COLOUR'] ?? '').toUpperCase()))
      const part: Template = {
        type: 'robLists_getIndex',
        mutation: { attrs: { statement: 'false', at: 'true', datatype: 'Number' } },
        fields: { MODE: 'GET', WHERE: 'FROM_START' },
        values: { VALUE: sensor('colour', 'RGB', port), AT: number(at) },
      }
      return calculate('DIVIDE', calculate('MULTIPLY', part, number(100)), number(255))
    }
    default:
      return sensor('colour', 'LIGHT', port)
  }
}

function motorSteps({ type, fields }: NeuronOutline, k: number): readonly Template[] {
  if (type !== 'ai_nn_output_node') return []
  const MOTORPORT = fields['OUTPUTNODE']?.at(-1) ?? 'C'
  return [{ type: 'robActions_motor_on', fields: { MOTORPORT }, values: { POWER: output(k) } }]
}

function wordStep({ fields }: NeuronOutline, row: number, k: number): Template {
  const show = (word: string): Template => ({
    type: 'robActions_display_text',
    values: { OUT: text(word), COL: number(0), ROW: number(row) },
  })
  return choose([[compare('GT', output(k), number(0)), show(fields['OUTPUTNODE'] ?? '')]], show(nothing))
}

const lamps: { readonly [colour: string]: string } = {
  ...{ '#00642E': 'GREEN', '#F7D118': 'ORANGE', '#B30006': 'RED' },
}

/** The highest above 0 lights up, of equals the upper one: those before it are lower than it or than one after it. */
function lampSteps(outputs: readonly NeuronOutline[]): readonly Template[] {
  const own = outputs.flatMap(({ type, fields }, k) =>
    type === 'ai_nn_output_node_led' ? [{ k, colour: (fields['OUTPUTNODE'] ?? '').toUpperCase() }] : [],
  )
  if (own.length === 0) return []
  const ways = own.map(({ k, colour }, at) => {
    const later = own.slice(at + 1).map((other) => compare('GTE', output(k), output(other.k)))
    const wins = later.reduce(both, compare('GT', output(k), number(0)))
    const on: Template = {
      ...{ type: 'actions_bricklight_on_ev3', fields: { COLOUR: lamps[colour] ?? 'GREEN', MODE: 'ON' } },
    }
    return [wins, on] as const
  })
  return [choose(ways, { type: 'actions_bricklight_off_ev3', fields: { MODE: 'OFF' } })]
}
