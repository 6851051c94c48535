import type { Block } from '@botgarten/blocks'
import { Failure, type WholeTwin } from './twin.ts'

// Rule 38: the network by names. Ours in tests has one layer of inputs and one of outputs.

const nameOf = (block: Block, field: string) => block.fields?.[field] ?? ''

export function weightOf(twin: WholeTwin, block: Block): number {
  const [from, to] = [nameOf(block, 'FROM'), nameOf(block, 'TO')]
  const { layers, weights } = twin.brain(block)
  const isLink = layers[0]!.some(({ id }) => id === from) && layers[1]!.some(({ id }) => id === to)
  if (!isLink) throw new Failure(block, 'noSuchNeuron')
  return twin.net.weights.get(`${from} ${to}`) ?? weights[from]?.[to] ?? 0
}

export function biasOf(twin: WholeTwin, block: Block): number {
  const name = nameOf(block, 'NAME')
  const neuron = twin.brain(block).layers[1]!.find(({ id }) => id === name)
  if (!neuron) throw new Failure(block, 'noSuchNeuron')
  return twin.net.biases.get(name) ?? neuron.bias
}

/** Thinks once: an output is its bias and what comes over its links. */
export function think(twin: WholeTwin, block: Block): void {
  const { layers, weights } = twin.brain(block)
  const [inputs, outputs] = [layers[0]!, layers[1]!]
  const valueOf = (id: string) => twin.net.inputs.get(id) ?? 0
  twin.host.think(
    networkIn(twin),
    inputs.map(({ id }) => valueOf(id)),
  )
  for (const { id: to, bias } of outputs) {
    const terms = inputs.map(
      ({ id: from }) => valueOf(from) * (twin.net.weights.get(`${from} ${to}`) ?? weights[from]?.[to] ?? 0),
    )
    const sum = terms.reduce((total, term) => total + term, 0)
    twin.net.outputs.set(to, (twin.net.biases.get(to) ?? bias) + sum)
  }
}

/** The start block carries the network. */
const networkIn = (twin: WholeTwin): string => twin.program.stacks[0]!.blocks[0]!.id
