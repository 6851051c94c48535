import { definitions, isBlockType, plugged } from '@botgarten/blocks'
import type { Block, Definition } from '@botgarten/blocks'
import type { Program } from '../types.ts'

/** Where a block stands decides what it may be. */
type Place = 'hat' | 'statement' | 'value'

/** A block with all that the interpreter looks up of it, found once. Blocks that are switched off are left out. */
export interface IndexedBlock {
  readonly block: Block
  readonly definition: Pick<Definition, 'run' | 'acts'>
  readonly isValue: boolean
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
  return definition.look.shape === place ? definition : misplaced
}

type Blocks = Map<string, IndexedBlock>

function indexBlock(block: Block, place: Place, below: IndexedBlock | null, blocks: Blocks): IndexedBlock {
  const indexed = {
    block,
    definition: definitionOf(block, place),
    isValue: place === 'value',
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
    if (child) values.set(input, indexBlock(child, 'value', null, blocks))
  }
  return values
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
    const alone = stack.blocks.length === 1 && isLooseValue(top)
    indexRows(stack.blocks, isStart(top) ? 'hat' : alone ? 'value' : 'statement', blocks)
  }
  const start = startingStacks(program)[0]?.blocks[0]
  return { blocks, start: (start && blocks.get(start.id)) ?? null }
}

/** A value block that lies about can be asked for its value, too. */
const isLooseValue = (block: Block | undefined) =>
  block !== undefined && isBlockType(block.type) && definitions[block.type].look.shape === 'value'
