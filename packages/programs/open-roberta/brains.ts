import type { Block } from '@botgarten/blocks'
import type { Brain } from '@botgarten/learning/neural-network/brain'
import * as v from 'valibot'
import { brainSchema } from '../project/schema-brain.ts'
import type { Program, Project } from '../types.ts'
import { networkIn, withNetwork } from './network-json.ts'

const type = 'ai_neural_network'
/** Blocks that carry a network of today's Open Roberta. */
const carriers = new Set(['robControls_start', 'robActions_NNstep'])
const marked = v.object({ botgartenBrain: brainSchema })

/** The program with the weights of its networks as data of their blocks, since a file of Open Roberta has no place for them. */
export const withBrains = (program: Program, brains: Project['brains']): Program => ({
  ...program,
  stacks: program.stacks.map((stack) => ({
    ...stack,
    blocks: stack.blocks.map((block) => withBrain(block, brains)),
  })),
})

function withBrain(block: Block, brains: Project['brains']): Block {
  const { values, statements } = block
  return {
    ...withOwn(block, Object.hasOwn(brains, block.id) ? brains[block.id] : undefined),
    ...(values && { values: mapped(values, (child) => withBrain(child, brains)) }),
    ...(statements && {
      statements: mapped(statements, (row) => row.map((child) => withBrain(child, brains))),
    }),
  }
}

function withOwn(block: Block, brain: Brain | undefined): Block {
  if (block.type === type) return withData(block, brain)
  if (!carriers.has(block.type) || block.data === undefined || !brain) return block
  return { ...block, data: withNetwork(block.data, brain) }
}

/** Weights that the block brought along before are not kept beside. */
function withData(block: Block, brain: Brain | undefined): Block {
  const { data, ...rest } = block
  const foreign = data !== undefined && brainOf(data) === null
  if (!brain || !isTrained(brain)) return foreign ? block : rest
  return { ...rest, data: JSON.stringify({ botgartenBrain: brain }) }
}

const isTrained = ({ weights, sets }: Brain) => Object.keys(weights).length + Object.keys(sets).length > 0

const mapped = <Value>(record: { readonly [name: string]: Value }, change: (value: Value) => Value) =>
  Object.fromEntries(Object.entries(record).map(([name, value]) => [name, change(value)]))

/** The weights that travelled in a program's blocks. What is broken is left out. */
export const brainsIn = ({ stacks }: Program): Project['brains'] =>
  Object.fromEntries(stacks.flatMap(({ blocks }) => blocks.flatMap(brainsOf)))

function brainsOf(block: Block): (readonly [string, Brain])[] {
  const { data = '' } = block
  const own = block.type === type ? brainOf(data) : carriers.has(block.type) ? networkIn(data) : null
  const inside = [...Object.values(block.values ?? {}), ...Object.values(block.statements ?? {}).flat()]
  return [...(own ? [[block.id, own] as const] : []), ...inside.flatMap(brainsOf)]
}

function brainOf(data: string): Brain | null {
  try {
    const { success, output } = v.safeParse(marked, JSON.parse(data))
    return success ? output.botgartenBrain : null
  } catch {
    return null
  }
}
