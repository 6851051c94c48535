import * as Blockly from 'blockly/core'
import { definitions, isBlockType, type Block } from '@botgarten/blocks'
import { shapeOf, statementNames, type Program } from '@botgarten/programs'
import { append, awaited, knowShadows, putBeside, toWorkspace, unheard } from '../../model/program.ts'
import { stateOfRow, type Loose } from '../../model/state.ts'

/** Rows of blocks that are made at once: as many as a high screen shows. */
const atFirst = 16
const pieceLength = 4
/** Milliseconds of work before the page may draw again. */
const slice = 25

type Rows = Map<string, readonly Block[]>

/** A large program on its way to the workspace. */
export interface Slices {
  /** Makes all that is missing now; of one stack only, where a block of it is given. */
  finish(of?: Blockly.Block): void
  stop(): void
}

/**
 * Shows the beginnings of a program's rows on an empty workspace, and the rest in slices; `see` is called after
 * each, `ready` after the last. What is not there yet is known to `toProgram`.
 */
export function showInSlices(
  program: Program,
  workspace: Blockly.WorkspaceSvg,
  see: () => void,
  ready: () => void,
): Slices {
  const rest: Rows = new Map()
  const seen = workspace.getMetricsManager().getViewMetrics(true)
  const far = (x: number, y: number) => x > seen.width || y > seen.height
  const stacks = program.stacks.map(({ x, y, blocks }) => ({
    x,
    y,
    blocks: cut(blocks, far(x, y) ? 1 : atFirst, rest),
  }))
  awaited.set(workspace, rest)
  Blockly.utils.dom.startTextWidthCache()
  toWorkspace({ ...program, stacks }, workspace)
  workspace.setResizesEnabled(false)
  see()

  let timer: ReturnType<typeof setTimeout> | undefined
  const stop = () => {
    if (timer === undefined) return
    clearTimeout(timer)
    timer = undefined
    awaited.delete(workspace)
    workspace.setResizesEnabled(true)
    Blockly.utils.dom.stopTextWidthCache()
  }
  const work = (of: (anchor: Blockly.Block) => boolean, until: number) =>
    unheard(workspace, () => {
      for (const [id, rows] of rest) {
        if (performance.now() > until) return
        const anchor = workspace.getBlockById(id)
        if (!anchor || of(anchor)) more(id, anchor, rows)
      }
    })
  const more = (id: string, anchor: Blockly.BlockSvg | null, rows: readonly Block[]) => {
    rest.delete(id)
    if (!anchor) return append({ x: 0, y: 0, blocks: rows }, workspace)
    const last = hang(cut(rows.slice(0, pieceLength), atFirst, rest), anchor)
    if (rows.length > pieceLength) rest.set(last.id, rows.slice(pieceLength))
    else drawAround(last)
  }
  const goOn = () => {
    if (!workspace.isDragging()) {
      work(() => true, performance.now() + slice)
      see()
    }
    if (rest.size === 0) end()
    else timer = setTimeout(goOn)
  }
  const end = () => {
    stop()
    ready()
    see()
  }
  timer = setTimeout(goOn)
  return {
    finish(of) {
      if (timer === undefined) return
      const root = of?.getRootBlock()
      work((anchor) => root === undefined || anchor.getRootBlock() === root, Infinity)
      if (rest.size === 0) end()
    },
    stop,
  }
}

const endOf = (block: Blockly.BlockSvg): Blockly.BlockSvg => {
  let last = block
  for (let next: Blockly.BlockSvg | null = block; next; next = next.getNextBlock()) last = next
  return last
}

/** Hangs a row at the end of the row that a block stands in. Returns the block that is its end then. */
function hang(blocks: readonly Block[], after: Blockly.BlockSvg): Blockly.BlockSvg {
  const { workspace } = after
  const end = endOf(after)
  const loose: Loose = []
  const state = stateOfRow(blocks, loose, false)
  const { nextConnection: parentConnection } = end
  if (state && parentConnection) {
    alone(end, () => {
      const options = { parentConnection }
      const first = Blockly.serialization.blocks.appendInternal(state, workspace, options)
      for (const block of first.getDescendants(false)) knowShadows(block)
      Blockly.renderManagement.triggerQueuedRenders(workspace)
    })
  }
  putBeside(loose, end.getRelativeToSurfaceXY(), workspace)
  return endOf(end)
}

/** Blockly draws a block with all that it hangs on, up to the first: of a long row again and again. */
function alone(block: Blockly.BlockSvg, change: () => void) {
  block.getParent = () => null
  try {
    change()
  } finally {
    delete (block as { getParent?: unknown }).getParent
  }
}

/** A row is whole: what it stands in grows round it. */
function drawAround(block: Blockly.BlockSvg) {
  const around = block.getSurroundParent()
  if (!around) return
  void around.queueRender()
  Blockly.renderManagement.triggerQueuedRenders(block.workspace)
}

/** The first blocks of a row; the others go to `rest`, under the id of the block they follow. So inside of each block. */
function cut(row: readonly Block[], keep: number, rest: Rows): readonly Block[] {
  const kept = row.length > keep && row.every(isStep) ? row.slice(0, keep) : row
  const last = kept.at(-1)
  if (last && kept !== row) rest.set(last.id, row.slice(keep))
  return kept.map((block) => cutInside(block, rest))
}

function cutInside(block: Block, rest: Rows): Block {
  if (!block.statements || block.collapsed || !isBlockType(block.type)) return block
  const shown = statementNames(block, definitions[block.type].look)
  const cuts = Object.entries(block.statements).map(
    ([name, row]) => [name, shown.includes(name) ? cut(row, atFirst, rest) : row] as const,
  )
  return { ...block, statements: Object.fromEntries(cuts) }
}

/** Does it stand in a row, whatever comes before and after it? */
function isStep(block: Block, at: number): boolean {
  const look = isBlockType(block.type) ? definitions[block.type].look : undefined
  const shape = look && shapeOf(block, look)
  return shape === 'statement' || (shape === 'hat' && at === 0)
}
