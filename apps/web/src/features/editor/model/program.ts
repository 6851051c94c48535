import * as Blockly from 'blockly/core'
import type { Block, Look } from '@botgarten/blocks'
import type { Program, Stack } from '@botgarten/programs'
import { isBotBlock, type BotBlock, type Rest } from './bot-block.ts'
import { isFileField } from '../view/fields.ts'
import { foot, linesOf } from './list.ts'
import { presetShadow } from './fits.ts'
import { plainId } from './ids.ts'
import { positionOf, shownPosition } from './positions.ts'
import { stateOfRow, stateOfTemplate, type Loose, type State } from './state.ts'

/** A block of a type that this version does not know (unknown.ts). */
export interface UnknownBlock extends Blockly.Block {
  /** The block as the file has it, with all that hangs in it. */
  raw: Block
}

const isUnknownBlock = (block: Blockly.Block): block is UnknownBlock => 'raw' in block

const besides = 60
const { VALUE, STATEMENT } = Blockly.inputs.inputTypes

/** Blocks of a large program that are not on the workspace yet, by the id of the block they come after. */
export const awaited = new WeakMap<Blockly.Workspace, ReadonlyMap<string, readonly Block[]>>()

/** Shows a program on an empty workspace. Fires no events: what is loaded is not an edit. */
export function toWorkspace(program: Program, workspace: Blockly.Workspace): void {
  const rendered = workspace instanceof Blockly.WorkspaceSvg ? workspace : null
  rendered?.setResizesEnabled(false)
  unheard(workspace, () => {
    for (const stack of program.stacks) append(stack, workspace)
    for (const block of workspace.getAllBlocks(false)) knowShadows(block)
  })
  rendered?.setResizesEnabled(true)
}

/** Without events, measuring each word once, and putting sockets in order once instead of for each block. */
export function unheard(workspace: Blockly.Workspace, change: () => void): void {
  const sockets = workspace instanceof Blockly.WorkspaceSvg ? workspace.connectionDBList : []
  Blockly.Events.disable()
  Blockly.utils.dom.startTextWidthCache()
  for (const list of sockets) list?.beginBulkUpdates()
  try {
    change()
  } finally {
    for (const list of sockets) list?.endBulkUpdates()
    Blockly.utils.dom.stopTextWidthCache()
    Blockly.Events.enable()
  }
}

export function append(stack: Stack, workspace: Blockly.Workspace): void {
  const loose: Loose = []
  const state = stateOfRow(stack.blocks, loose, true)
  if (state) Blockly.serialization.blocks.append({ ...state, x: stack.x, y: stack.y }, workspace)
  putBeside(loose, stack, workspace)
}

export function putBeside(loose: Loose, { x, y }: { x: number; y: number }, workspace: Blockly.Workspace) {
  loose.forEach((blocks, at) => append({ x: x + besides, y: y + besides * (at + 1), blocks }, workspace))
}

/** Blockly's own way builds every shadow and throws it away where a block stands in its place. */
interface Shadowed {
  applyShadowState(shadow: { shadowDom: null; shadowState: State }): void
}

/** Tells the inputs of a block what comes back when their block is pulled out. */
export function knowShadows(block: Blockly.Block) {
  for (const { name, connection } of block.inputList) {
    const stands = connection?.targetBlock()
    const shadow = stands && !stands.isShadow() && presetShadow(block.type, name)
    if (!connection || !shadow || connection.getShadowState()) continue
    const shadowState = { ...stateOfTemplate(shadow), id: plainId() }
    ;(connection as unknown as Shadowed).applyShadowState({ shadowDom: null, shadowState })
  }
}

/** All blocks with the names that Blockly's undo knows them by. */
export const statesOn = (workspace: Blockly.Workspace): readonly State[] =>
  workspace.getTopBlocks(false).flatMap((block) => {
    const state = Blockly.serialization.blocks.save(block)
    return state ? [{ ...state, ...shownPosition(block) }] : []
  })

export function restore(states: readonly State[], workspace: Blockly.Workspace): void {
  for (const state of states) Blockly.serialization.blocks.append(state, workspace)
}

/** The blocks of a workspace as frozen data. `base`: the program it was, for what the workspace does not show. */
export function toProgram(workspace: Blockly.Workspace, base: Program): Program {
  const tops = workspace.getTopBlocks(false).filter((block) => !block.isInsertionMarker())
  const stacks = tops.map((block) => ({ ...positionOf(block), blocks: rowFrom(block) }))
  return deepFreeze({ ...base, stacks })
}

function rowFrom(first: Blockly.Block | null): Block[] {
  const row: Block[] = []
  const coming = first && awaited.get(first.workspace)
  const late: Block[] = []
  for (let block = first; block; block = block.getNextBlock()) {
    if (!block.isInsertionMarker()) row.push(blockOf(block))
    late.push(...(coming?.get(block.id) ?? []))
  }
  return [...row, ...late]
}

function blockOf(block: Blockly.Block): Block {
  if (isUnknownBlock(block)) return block.raw
  if (!isBotBlock(block)) return { id: block.id, type: block.type }
  const rest = block.extra.rest ?? {}
  const { look } = block.definition
  const comment = block.getCommentText()
  return {
    id: block.id,
    type: block.type,
    ...filled('fields', { ...rest.fields, ...fieldsOf(block, look, rest) }),
    ...mutationOf(block, look, rest),
    ...filled('values', { ...rest.values, ...valuesOf(block, look) }),
    ...filled('statements', { ...rest.statements, ...statementsOf(block) }),
    ...(comment && { comment }),
    ...(block.hasDisabledReason('MANUALLY_DISABLED') && { disabled: true }),
    ...(block.isCollapsed() && { collapsed: true }),
    ...((block.isShadow() || rest.shadow) && { shadow: true }),
    ...besidesShown(rest),
  }
}

const besidesShown = ({ data, hide, inline, flags }: Rest) => ({
  ...(data !== undefined && { data }),
  ...(hide !== undefined && { hide }),
  ...(inline !== undefined && { inline }),
  ...(flags !== undefined && { flags }),
})

const filled = <Name extends string, Value>(name: Name, record: { [key: string]: Value }) =>
  (Object.keys(record).length > 0 ? { [name]: record } : {}) as { [key in Name]?: typeof record }

function fieldsOf(block: BotBlock, look: Look, { told }: Rest) {
  const fields: Record<string, string> = {}
  for (const { name, preset } of look.fields) {
    const field = block.getField(name)
    const text = field && isFileField(field) ? field.toFile() : String(preset)
    const silent = told && !told.fields.includes(name) && text === String(preset)
    if (!silent) fields[name] = text
  }
  return fields
}

function mutationOf(block: BotBlock, look: Look, { told, args }: Rest): Pick<Block, 'mutation'> {
  const written = told?.attributes
  const attrs: Record<string, string> = { ...block.extra.attributes }
  for (const [name, value] of Object.entries(look.mutation ?? {})) {
    if (written !== undefined && !written?.includes(name)) continue
    attrs[name] = saidBy(block, value, attrs[name], told?.repeated)
  }
  const lines = linesOf(block)
  if (look.items && (written === undefined || written?.includes('items') || lines.length > 0)) {
    attrs['items'] = String(lines.length)
  }
  if (Object.keys(attrs).length === 0 && !written && !args) return {}
  return { mutation: { attrs, ...(args && { args }) } }
}

function saidBy(
  block: BotBlock,
  said: NonNullable<Look['mutation']>[string],
  before: string | undefined,
  repeated: Block['fields'],
): string {
  if (typeof said === 'string') return before ?? said
  const value = String(block.getFieldValue(said.field))
  if (before !== undefined && repeated?.[said.field] === value) return before
  return 'is' in said ? String(said.is.includes(value)) : value
}

function valuesOf(block: BotBlock, look: Look) {
  const values: Record<string, Block> = {}
  const take = (input: string, name: string) => {
    const child = block.getInputTargetBlock(input)
    if (child && !child.isInsertionMarker()) values[name] = blockOf(child)
  }
  for (const { name, type } of block.inputList)
    if (type === VALUE && name !== foot && !linesOf(block).includes(name)) take(name, name)
  linesOf(block).forEach((line, at) => take(line, `${look.items?.prefix ?? ''}${at}`))
  return values
}

function statementsOf(block: BotBlock) {
  const statements: Record<string, Block[]> = {}
  for (const { name, type } of block.inputList) {
    const row = type === STATEMENT ? rowFrom(block.getInputTargetBlock(name)) : []
    if (row.length > 0) statements[name] = row
  }
  return statements
}

function deepFreeze<Value>(value: Value): Value {
  if (typeof value !== 'object' || value === null || Object.isFrozen(value)) return value
  Object.values(value).forEach(deepFreeze)
  return Object.freeze(value)
}
