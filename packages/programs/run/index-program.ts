import { definitions, isBlockType, plugged } from '@botgarten/blocks'
import type { Block, Definition, Shape } from '@botgarten/blocks'
import { shapeOf } from './shape-of.ts'
import type { Program } from '../types.ts'

/** Where a block stands decides what it may be. */
type Place = Shape

/** A block with all that the interpreter looks up of it, found once. Blocks that are switched off are left out. */
export interface IndexedBlock {
  readonly block: Block
  readonly definition: Pick<Definition, 'run' | 'acts' | 'loops'>
  /** It hands something up when it is done: a value block, a function. */
  readonly isValue: boolean
  readonly isFunction: boolean
  /** It runs a net, looks into a table, or is a condition: each time is a decision. */
  readonly decides: boolean
  readonly values: ReadonlyMap<string, IndexedBlock>
  /** The first block in each statement input. */
  readonly statements: ReadonlyMap<string, IndexedBlock>
  /** The block below it. */
  readonly below: IndexedBlock | null
}

/** A program, ready to run. */
export interface ProgramIndex {
  readonly blocks: ReadonlyMap<string, IndexedBlock>
  /** The start block; null where there is none, and nothing runs. */
  readonly start: IndexedBlock | null
  /** By name; of several with one name the first. */
  readonly functions: ReadonlyMap<string, IndexedFunction>
  /** Id of the block that carries the network of the `robActions_NNstep` family. */
  readonly networkId: string
}

interface IndexedFunction {
  readonly block: IndexedBlock
  /** Names of its parameters. */
  readonly parameters: readonly string[]
}

const unable = (problem: string): IndexedBlock['definition'] => {
  const failure = { next: 'fail', problem } as const
  return { acts: false, run: () => failure }
}
const unknown = unable('problem.unknownBlock')
const misplaced = unable('problem.wrongKind')

function definitionOf(block: Block, place: Place): IndexedBlock['definition'] {
  if (!isBlockType(block.type)) return unknown
  const definition = definitions[block.type]
  return shapeOf(block, definition.look) === place ? definition : misplaced
}

type Blocks = Map<string, IndexedBlock>

/** Blocks that run a net or look into a learned table. */
const deciding: ReadonlySet<string> = new Set(['ai_neural_network', 'robActions_NNstep', 'ai_try_act'])
/** Inputs of conditions: of if, of a choice between two values, of wait. */
const condition = /^(IF\d*|WAIT\d+)$/

function indexBlock(
  block: Block,
  place: Place,
  below: IndexedBlock | null,
  blocks: Blocks,
  input = '',
): IndexedBlock {
  const indexed = {
    block,
    definition: definitionOf(block, place),
    isValue: place === 'value' || place === 'function',
    isFunction: place === 'function',
    decides: deciding.has(block.type) || condition.test(input),
    values: indexValues(block, blocks),
    statements: indexStatements(block, blocks),
    below,
  }
  blocks.set(block.id, indexed)
  return indexed
}

function indexValues(block: Block, blocks: Blocks) {
  const values = new Map<string, IndexedBlock>()
  for (const input of Object.keys(block.values ?? {})) {
    const child = plugged(block, input)
    if (child) values.set(input, indexBlock(child, 'value', null, blocks, input))
  }
  for (const [input, child] of Object.entries(writtenIn(block)))
    values.set(input, indexBlock(child, 'value', null, blocks))
  return values
}

/** Blocks that are written in the block as text. */
function writtenIn({ type, ...block }: Block): NonNullable<Block['values']> {
  const written = isBlockType(type) ? definitions[type].written?.({ type, ...block }) : undefined
  return written && 'values' in written ? written.values : {}
}

function indexStatements(block: Block, blocks: Blocks) {
  const statements = new Map<string, IndexedBlock>()
  for (const [input, rows] of Object.entries(block.statements ?? {})) {
    const first = indexRows(rows, 'statement', blocks)
    if (first) statements.set(input, first)
  }
  return statements
}

/** From the bottom up, so that each block knows the one below. */
function indexRows(rows: readonly Block[], top: Place, blocks: Blocks): IndexedBlock | null {
  let below: IndexedBlock | null = null
  for (let k = rows.length - 1; k >= 0; k--) {
    const block = rows[k]
    if (!block || block.disabled === true) continue
    below = indexBlock(block, k === 0 ? top : 'statement', below, blocks)
  }
  return below
}

const isStart = (block: Block | undefined) => block?.type === 'robControls_start' && block.disabled !== true

/** Where Bo begins: the stacks under a start block. */
export const startingStacks = ({ stacks }: Program) => stacks.filter(({ blocks }) => isStart(blocks[0]))

/** Looks a program up once; every run and every tick uses the same index. */
export function indexProgram(program: Program): ProgramIndex {
  const blocks: Blocks = new Map()
  for (const stack of program.stacks) {
    const top = stack.blocks[0]
    indexRows(stack.blocks, placeOfTop(top, stack.blocks.length === 1), blocks)
  }
  const start = startingStacks(program)[0]?.blocks[0]
  return {
    blocks,
    start: (start && blocks.get(start.id)) ?? null,
    functions: functionsIn(program, blocks),
    networkId: networkIdIn(blocks, start),
  }
}

function placeOfTop(top: Block | undefined, alone: boolean): Place {
  if (isStart(top)) return 'hat'
  if (isFunction(top)) return 'function'
  return alone && isLooseValue(top) ? 'value' : 'statement'
}

const isFunction = (block: Block | undefined): block is Block =>
  block !== undefined && /^robProcedures_def/.test(block.type) && block.disabled !== true

/** The blocks that make a function, in the order of the stacks. */
export const functionBlocks = ({ stacks }: Program): readonly Block[] =>
  stacks.map(({ blocks }) => blocks[0]).filter(isFunction)

/** Names that a row of declarations makes. */
export const declaredIn = (rows: readonly Block[] = []): readonly Block[] =>
  rows.filter(({ disabled, fields }) => disabled !== true && fields?.VAR !== undefined)

function functionsIn(program: Program, blocks: Blocks): ProgramIndex['functions'] {
  const functions = new Map<string, IndexedFunction>()
  for (const block of functionBlocks(program)) {
    const indexed = blocks.get(block.id)
    const name = block.fields?.NAME ?? ''
    const parameters = declaredIn(block.statements?.ST).map(({ fields }) => fields?.VAR ?? '')
    if (indexed && !functions.has(name)) functions.set(name, { block: indexed, parameters })
  }
  return functions
}

/** Today's files keep the network at the start block, old ones at the step. */
function networkIdIn(blocks: Blocks, start: Block | undefined): string {
  for (const { block } of blocks.values())
    if (block.type === 'robActions_NNstep' && block.data?.startsWith('{')) return block.id
  return start?.id ?? ''
}

/** A value block that lies about can be asked for its value, too. */
const isLooseValue = (block: Block | undefined) =>
  block !== undefined && isBlockType(block.type) && definitions[block.type].look.shape === 'value'
