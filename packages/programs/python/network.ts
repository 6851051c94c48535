import type { PythonAt } from '@botgarten/blocks'
import { biasOf, weightsOf, type Brain, type Neuron } from '@botgarten/learning/neural-network/brain'
import { brainFor, networks } from '../networks.ts'
import type { NetworkOutline, NeuronOutline } from '../types.ts'
import type { Draft } from './draft.ts'
import { namesOf, outputLines, reading } from './neurons.ts'
import type { Writer } from './writer.ts'

type Weights = ReturnType<typeof weightsOf>

interface Net {
  readonly draft: Draft
  readonly at: PythonAt
  readonly outline: NetworkOutline
  readonly brain: Brain
  readonly weights: Weights
  /** Names of the outputs in the file. */
  readonly outputs: readonly string[]
}

/** Reads the inputs, thinks, and does what the outputs say. */
export function callNetwork({ draft, usage }: Writer, at: PythonAt): void {
  const outline = networks(usage.program).find(({ id }) => id === at.block.id)
  if (!outline) return void at.gap('problem.noInputs')
  const brain = brainFor(outline, draft.input.brains[outline.id])
  const weights = weightsOf(brain, draft.input.set ?? '')
  const net = { draft, at, outline, brain, weights, outputs: namesOf(draft, outline) }
  const inputs = draft.names.of(`inputs ${outline.id}`, 'inputs')
  const lit = new Set(draft.pending)
  write(draft, lit, outline.inputs, () =>
    draft.line(`${inputs} = [${outline.inputs.map((neuron) => reading(at, neuron)).join(', ')}]`),
  )
  draft.pending = lit
  draft.line(`${net.outputs.join(', ')} = ${thinking(net)}(${inputs})`)
  outputLines(draft, at, outline, net.outputs, (neurons, line) => write(draft, lit, neurons, line))
  draft.pending = lit
}

/** Lines that belong to some neurons besides the network; a line of one neuron is its own first. */
function write(
  draft: Draft,
  lit: ReadonlySet<string>,
  neurons: readonly NeuronOutline[],
  line: () => void,
): void {
  const ids = neurons.map(({ id }) => id)
  draft.pending = new Set(ids.length === 1 ? [...ids, ...lit] : [...lit, ...ids])
  line()
}

const listed = (numbers: readonly number[]) => `[${numbers.map(String).join(', ')}]`

function constant({ draft }: Net, name: string, code: string, ids: readonly string[]): string {
  const own = draft.names.fresh(name)
  draft.constants.push({ code: `${own} = ${code}`, depth: 0, blocks: ids })
  return own
}

const row = ({ weights }: Net, from: readonly Neuron[], to: Neuron) =>
  from.map(({ id }) => weights[id]?.[to.id] ?? 0)

/** The function that thinks, made once. Gives its name. */
function thinking(net: Net): string {
  const { draft, at, outline } = net
  const name = draft.names.fresh('think')
  const words = draft.say('python.learned')
  draft.constants.push({ code: `# ${words}`, depth: 0, blocks: [outline.id] })
  const hidden = hiddenRows(net)
  const outs = outputRows(net, hidden.at(-1)?.[0] ?? 'inputs')
  const rows = [
    `def ${name}(inputs):`,
    ...hidden.map(([values, code]) => `    ${values} = ${code}`),
    ...outs.map((code) => `    ${code}`),
  ]
  // What it calls stands before it: helpers are made while its rows are written.
  draft.helpers.set(name, { rows, blocks: [at.block.id] })
  return name
}

/** A hidden layer: the name of its values, and how they are worked out. */
function hiddenRows(net: Net): readonly (readonly [values: string, code: string])[] {
  const layers = net.brain.layers.slice(0, -1)
  return layers.slice(1).map((neurons, k): readonly [string, string] => {
    const before = layers[k]!
    const number = layers.length > 2 ? `_${k + 1}` : ''
    const ids = [net.outline.hidden[k]?.id ?? '', net.outline.id]
    const rows = neurons.map((neuron) => listed(row(net, before, neuron)))
    const weights = constant(net, `HIDDEN_WEIGHTS${number}`, `[${rows.join(', ')}]`, ids)
    const biases = constant(
      net,
      `HIDDEN_BIASES${number}`,
      listed(neurons.map((neuron) => biasOf(net.weights, neuron))),
      ids,
    )
    const from = k === 0 ? 'inputs' : `hidden_${k}`
    const sums = net.at.call('layer', from, weights, biases)
    const values = layers.length > 2 ? `hidden_${k + 1}` : 'hidden'
    return [values, activated(net, neurons[0]?.activation, sums)]
  })
}

/** A layer's sums with what becomes of each. */
function activated({ at }: Net, activation: Neuron['activation'] | undefined, sums: string): string {
  if (activation === undefined || activation === 'identity') return sums
  if (activation === 'softmax') return at.call('softmax', sums)
  return `[${at.call(activation, 'value')} for value in ${sums}]`
}

function outputRows(net: Net, values: string): readonly string[] {
  const neurons = net.brain.layers.at(-1) ?? []
  const from = net.brain.layers.at(-2) ?? []
  const sums = neurons.map((neuron, k) => outputSum(net, neuron, values, from, net.outputs[k] ?? ''))
  const rows = sums.map((sum, k) => `${net.outputs[k]} = ${sum}`)
  const together = neurons.some(({ activation }) => activation === 'softmax')
  const all = net.outputs.join(', ')
  if (together) return [...rows, `return ${net.at.call('softmax', `[${all}]`)}`]
  return sums.length === 1 ? [`return ${sums[0]}`] : [...rows, `return ${all}`]
}

function outputSum(net: Net, neuron: Neuron, values: string, from: readonly Neuron[], name: string): string {
  const { at, outline } = net
  const ids = [neuron.id, outline.id]
  const weights = constant(net, `WEIGHTS_${name.toUpperCase()}`, listed(row(net, from, neuron)), ids)
  const bias = biasOf(net.weights, neuron)
  const sum = at.call('total', values, weights)
  const whole =
    bias === 0 ? sum : `${sum} + ${constant(net, `BIAS_${name.toUpperCase()}`, String(bias), ids)}`
  const { activation } = neuron
  return activation === 'identity' || activation === 'softmax' ? whole : at.call(activation, whole)
}
