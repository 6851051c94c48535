import { definitions, filledRows, hiddenIn, inputListOf, isBlockType, plugged } from '@botgarten/blocks'
import type { Block, NeuronLook } from '@botgarten/blocks'
import type { NetworkOutline, NeuronOutline, Program } from './types.ts'

/** Every network block of a program that is not switched off, those under a start block and those that lie about. */
export const networks = ({ stacks }: Program): NetworkOutline[] =>
  stacks.flatMap(({ blocks }) => blocks.flatMap(networksIn))

function networksIn(block: Block): NetworkOutline[] {
  if (block.disabled === true) return []
  const own = block.type === 'ai_neural_network' ? [outline(block)] : []
  const inside = [...Object.values(block.values ?? {}), ...Object.values(block.statements ?? {}).flat()]
  return [...own, ...inside.flatMap(networksIn)]
}

const outline = (block: Block): NetworkOutline => ({
  id: block.id,
  inputs: neuronsIn(inputListOf(block), 'input'),
  hidden: hiddenIn(block),
  outputs: neuronsIn(plugged(block, 'OUTPUT_LAYER'), 'output'),
})

const neuronsIn = (list: Block | undefined, layer: NeuronLook['layer']): NeuronOutline[] =>
  (list ? filledRows(list) : []).flatMap((block) => neuronOf(block, layer))

function neuronOf({ id, type, fields = {} }: Block, layer: NeuronLook['layer']): NeuronOutline[] {
  const look = isBlockType(type) ? definitions[type].neuron : undefined
  return look?.layer === layer ? [{ id, type, fields, look }] : []
}
