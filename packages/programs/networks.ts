import { definitions, filledRows, hiddenIn, inputListOf, isBlockType, plugged } from '@botgarten/blocks'
import type { Block, NeuronLook } from '@botgarten/blocks'
import { reachedIn } from './check/reached.ts'
import { startingStacks } from './run/index-program.ts'
import { emptyBrain, follow, hiddenId, type Brain } from '@botgarten/learning/neural-network/brain'
import type { NetworkInUse, NetworkOutline, NeuronOutline, Program } from './types.ts'

/** Every network block of a program that is not switched off, those under a start block and those that lie about. */
export const networks = ({ stacks }: Program): NetworkOutline[] =>
  stacks
    .flatMap(({ blocks }) => blocks.flatMap((block) => networksIn(block)))
    .flatMap(({ off, ...one }) => (off ? [] : [one]))

/** Every network block with what keeps it from running: first those that run, last those that are switched off. */
export function networksByUse(program: Program): readonly NetworkInUse[] {
  const reached = reachedIn(program)
  const begun = startingStacks(program)[0]
  const all = program.stacks.flatMap((stack) =>
    stack.blocks.flatMap((block) =>
      networksIn(block).map(({ off, ...network }): NetworkInUse => {
        if (off) return { ...network, idle: 'off' }
        return { ...network, idle: reached.has(network.id) ? null : stack === begun ? 'behind' : 'loose' }
      }),
    ),
  )
  const rank = ({ idle }: NetworkInUse) => (idle === null ? 0 : idle === 'off' ? 2 : 1)
  return [0, 1, 2].flatMap((wanted) => all.filter((network) => rank(network) === wanted))
}

function networksIn(block: Block, above = false): (NetworkOutline & { off: boolean })[] {
  const off = above || block.disabled === true
  const own = block.type === 'ai_neural_network' ? [{ ...outline(block), off }] : []
  const inside = [...Object.values(block.values ?? {}), ...Object.values(block.statements ?? {}).flat()]
  return [...own, ...inside.flatMap((inner) => networksIn(inner, off))]
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

/** The brain of a network block: its neurons follow the blocks, its weights stay (running.md 11). */
export function brainFor({ inputs, hidden, outputs }: NetworkOutline, brain: Brain = emptyBrain): Brain {
  const ids = (neurons: readonly NeuronOutline[]) => neurons.map((neuron) => neuron.id)
  const between = hidden.map(({ id, neurons, activation }) =>
    Array.from({ length: neurons }, (_, k) => ({ id: hiddenId(id, k + 1), activation })),
  )
  return follow(brain, ids(inputs), ...between, ids(outputs))
}
