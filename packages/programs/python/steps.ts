import type { PythonAt } from '@botgarten/blocks'
import { weightsOf, biasOf, type Brain } from '@botgarten/learning/neural-network/brain'
import { indexProgram } from '../run/index-program.ts'
import type { Draft } from './draft.ts'
import { quote } from './quote.ts'
import type { Writer } from './writer.ts'

const brainOf = ({ draft, usage }: Writer): Brain | undefined =>
  draft.input.brains[indexProgram(usage.program).networkId]

const places = {
  inputs: 'net_inputs',
  outputs: 'net_outputs',
  biases: 'net_biases',
  weights: 'net_weights',
} as const

const nameOf = (draft: Draft, what: keyof typeof places) => draft.names.of(`steps ${what}`, places[what])

const dict = (pairs: readonly (readonly [string, string])[]) =>
  `{${pairs.map(([name, code]) => `${quote(name)}: ${code}`).join(', ')}}`

/** The network by the names of its neurons, at the head of the file. */
function prepare({ draft }: Writer, at: PythonAt, brain: Brain): void {
  if (draft.names.of('steps made', 'run_network') && draft.helpers.has(draft.names.of('steps made', '')))
    return
  const weights = weightsOf(brain, draft.input.set ?? '')
  const [first = [], ...others] = brain.layers
  const behind = others.flat()
  const zeros = (neurons: Brain['layers'][number]) => dict(neurons.map(({ id }) => [id, '0']))
  const links = brain.layers.slice(0, -1).flatMap((layer, k) =>
    layer.map(({ id }) => {
      const to = brain.layers[k + 1]!.map(
        (neuron) => [neuron.id, String(weights[id]?.[neuron.id] ?? 0)] as const,
      )
      return [id, dict(to)] as const
    }),
  )
  const constants: readonly (readonly [string, string])[] = [
    [nameOf(draft, 'inputs'), zeros(first)],
    [nameOf(draft, 'outputs'), zeros(others.at(-1) ?? [])],
    [nameOf(draft, 'weights'), dict(links)],
    [nameOf(draft, 'biases'), dict(behind.map((neuron) => [neuron.id, String(biasOf(weights, neuron))]))],
  ]
  for (const [name, code] of constants)
    draft.constants.push({ code: `${name} = ${code}`, depth: 0, blocks: [at.block.id] })
  draft.helpers.set(draft.names.of('steps made', 'run_network'), { rows: running(draft, others), blocks: [] })
}

function running(draft: Draft, layers: Brain['layers']): readonly string[] {
  const names = layers.map((layer) => `[${layer.map(({ id }) => quote(id)).join(', ')}]`)
  const [inputs, outputs] = [nameOf(draft, 'inputs'), nameOf(draft, 'outputs')]
  const [weights, biases] = [nameOf(draft, 'weights'), nameOf(draft, 'biases')]
  return [
    `def ${draft.names.of('steps made', 'run_network')}():`,
    `    values = ${inputs}`,
    `    for names in [${names.join(', ')}]:`,
    '        sums = {}',
    '        for name in names:',
    `            sums[name] = ${biases}[name]`,
    '            for one in values:',
    `                sums[name] += values[one] * ${weights}[one][name]`,
    '        values = sums',
    `    ${outputs}.update(values)`,
  ]
}

function prepared(writer: Writer, at: PythonAt): Brain {
  const brain = brainOf(writer) ?? at.gap('problem.noNetwork')
  prepare(writer, at, brain)
  return brain
}

export function runStep(writer: Writer, at: PythonAt): void {
  prepared(writer, at)
  writer.draft.line(`${writer.draft.names.of('steps made', 'run_network')}()`)
}

const has = (neurons: readonly { readonly id: string }[], name: string | undefined) =>
  neurons.some(({ id }) => id === name)

/** Where a number of the network is kept. */
export function neuronPlace(
  writer: Writer,
  at: PythonAt,
  what: keyof typeof places,
  names: readonly string[],
): string {
  const { layers } = prepared(writer, at)
  const [name = '', to] = names
  const place = nameOf(writer.draft, what)
  if (what === 'outputs' && !has(layers.at(-1) ?? [], name)) return '0'
  const linked = layers.some((layer, k) => has(layer, name) && has(layers[k + 1] ?? [], to))
  const known = what === 'weights' ? linked : what !== 'biases' || has(layers.slice(1).flat(), name)
  if (!known) return at.gap('problem.noSuchNeuron', { name: names.join(' → ') })
  return `${place}${names.map((one) => `[${quote(one)}]`).join('')}`
}
