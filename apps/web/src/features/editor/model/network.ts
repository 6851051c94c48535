import type * as Blockly from 'blockly/core'
import { toolbox, type Template, type ValueType } from '@botgarten/blocks'
import { isBotBlock, type BotBlock } from './bot-block.ts'
import { addLine, grouped, linesOf, plugIn } from './list.ts'
import { fits } from './fits.ts'
import { freshNeuron } from './fresh.ts'

const layers: { readonly [layer in 'input' | 'output']: ValueType } = {
  input: 'InputLayer',
  output: 'OutputLayer',
}

/** Puts a neuron (without a template: one more of its kind) into a free line of a layer, a new line, or a new list. */
export function addNeuron(
  workspace: Blockly.Workspace,
  networkId: string,
  layer: 'input' | 'output',
  template?: Template,
): string | null {
  const network = workspace.getBlockById(networkId)
  if (!isBotBlock(network)) return null
  return grouped(() => {
    const list = listOf(network, layers[layer])
    if (!list) return null
    const free = linesOf(list).find((line) => !list.getInputTargetBlock(line))
    const added = template ?? freshNeuron(list)
    if (!added) return null
    const neuron = free === undefined ? addLine(list, added) : plugIn(list, free, added)
    return neuron?.id ?? null
  })
}

/** The list in the network's socket for this layer; an empty one where the socket is empty. */
function listOf(network: BotBlock, layer: ValueType): BotBlock | null {
  const socket = network.definition.look.inputs.find(
    (input) => input.kind === 'value' && input.accepts.includes(layer),
  )
  if (!socket) return null
  const list = network.getInputTargetBlock(socket.name) ?? plugIn(network, socket.name, emptyList(layer))
  return isBotBlock(list) ? list : null
}

function emptyList(layer: ValueType): Template {
  const templates = toolbox.flatMap(({ blocks }) => blocks)
  const { values: _neurons, ...list } = templates.find((template) => fits(template, [layer])) ?? { type: '' }
  return { ...list, ...(list.mutation && { mutation: { attrs: { ...list.mutation.attrs, items: '1' } } }) }
}
