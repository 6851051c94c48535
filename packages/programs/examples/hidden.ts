import { hiddenType, inputListOf, mostInLayer, plugged } from '@botgarten/blocks'
import type { Block } from '@botgarten/blocks'
import type { Program } from '../types.ts'

/** Activations that a hidden layer can practise with, as files say them. */
export const hiddenActivations = {
  relu: 'RELU',
  sigmoid: 'SIGMOID',
  tanh: 'TANH',
  identity: 'LINEAR',
} as const

export interface Hidden {
  readonly neurons: number
  readonly activation: keyof typeof hiddenActivations
}

/** The program whose network has these hidden layers, from the inputs on, in place of those it had. */
export const withHidden = (program: Program, network: string, layers: readonly Hidden[]): Program => ({
  ...program,
  stacks: program.stacks.map((stack) => ({
    ...stack,
    blocks: stack.blocks.map((block) => changed(block, network, layers)),
  })),
})

function changed(block: Block, network: string, layers: readonly Hidden[]): Block {
  if (block.id === network && plugged(block, 'INPUT_LAYER')) return between(block, layers)
  const inside = (one: Block) => changed(one, network, layers)
  const { values, statements } = block
  return {
    ...block,
    ...(values && { values: mapped(values, inside) }),
    ...(statements && { statements: mapped(statements, (rows) => rows.map(inside)) }),
  }
}

const mapped = <One>(all: { readonly [name: string]: One }, change: (one: One) => One) =>
  Object.fromEntries(Object.entries(all).map(([name, one]) => [name, change(one)]))

function between(block: Block, layers: readonly Hidden[]): Block {
  const list = inputListOf(block)
  if (!list) return block
  const chain = layers.reduce<Block>(
    (before, { neurons, activation }, index) => ({
      id: `${block.id}.hidden${index + 1}`,
      type: hiddenType,
      fields: {
        NEURONS: String(Math.min(neurons, mostInLayer)),
        ACTIVATION: hiddenActivations[activation],
      },
      values: { LAYER: before },
    }),
    list,
  )
  return { ...block, values: { ...block.values, INPUT_LAYER: chain } }
}
