import * as Blockly from 'blockly/core'
import { stacksOf, type Template } from '@botgarten/blocks'
import { grouped } from '../../model/list.ts'
import { stateOfRow, stateOfTemplate, type State } from '../../model/state.ts'

type Workspace = Blockly.WorkspaceSvg

/** The block that a hand or the keyboard was at last. */
function anchorOn(workspace: Workspace): Blockly.BlockSvg | null {
  const node = Blockly.FocusableTreeTraverser.findFocusedNode(workspace)
  return node ? workspace.getNavigator().getSourceBlockFromNode(node) : null
}

/** Puts a block of the toolbox at the one that was chosen last, where it fits; else below all others. Returns it. */
export function put(workspace: Workspace, template: Template): Blockly.BlockSvg {
  return grouped(() => {
    const anchor = anchorOn(workspace)
    const box = workspace.getBlocksBoundingBox()
    const state = { ...stateOfTemplate(template), x: box.left, y: box.bottom + 24 }
    const block = append(workspace, state)
    if (anchor) join(block, anchor)
    void show(workspace, block)
    return block
  })
}

/** Chosen, and where it can be seen. */
async function show(workspace: Workspace, block: Blockly.BlockSvg) {
  await Blockly.renderManagement.finishQueuedRenders()
  Blockly.getFocusManager().focusNode(block)
  workspace.scrollBoundsIntoView(block.getBoundingRectangle(), 24)
}

function join(block: Blockly.BlockSvg, anchor: Blockly.BlockSvg): void {
  if (block.outputConnection) return void gapFor(block, anchor)?.connect(block.outputConnection)
  const inside = emptyMouth(anchor)
  if (inside && goes(block.previousConnection, inside)) return void inside.connect(block.previousConnection!)
  for (let at: Blockly.BlockSvg | null = anchor; at && block.previousConnection; at = at.getSurroundParent())
    if (at.nextConnection && goes(block.previousConnection, at.nextConnection))
      return void at.nextConnection.connect(block.previousConnection)
}

/** Where blocks stand inside of a loop or a condition that has none yet. */
const emptyMouth = ({ inputList }: Blockly.BlockSvg): Blockly.Connection | undefined =>
  inputList.find(
    ({ type, connection }) => type === Blockly.inputs.inputTypes.STATEMENT && !connection?.targetBlock(),
  )?.connection ?? undefined

/** The first gap of a block, or of those around it, that takes this value. */
function gapFor(block: Blockly.BlockSvg, anchor: Blockly.BlockSvg): Blockly.Connection | null {
  const inputs = anchor.inputList.filter(({ type }) => type === Blockly.inputs.inputTypes.VALUE)
  for (const { connection } of inputs) {
    const there = connection?.targetBlock()
    if (connection && (!there || there.isShadow()) && goes(block.outputConnection, connection))
      return connection
  }
  const around = anchor.getParent()
  return around && anchor.outputConnection ? gapFor(block, around) : null
}

const goes = (block: Blockly.Connection | null, there: Blockly.Connection): boolean =>
  there.getConnectionChecker().canConnect(there, block, false)

/** Further from what is above than Blockly lets blocks snap. */
const apart = 60

/** Lays an example's blocks below all others; its variables are made where the program makes its own. One step of undo. */
export function putExample(workspace: Workspace, example: readonly Template[]): void {
  grouped(() => {
    const [row = [], ...functions] = stacksOf(example)
    const [start, ...rest] = row
    for (const made of start?.statements?.['ST'] ?? []) declare(workspace, made)
    const first = add(workspace, rest)
    for (const made of functions) if (!isThere(workspace, made[0]!, 'NAME')) add(workspace, made)
    if (first) void show(workspace, first)
  })
}

function add(workspace: Workspace, row: readonly Template[]): Blockly.BlockSvg | null {
  const state = stateOfRow(row, [], true)
  const { left, bottom } = workspace.getBlocksBoundingBox()
  return state ? append(workspace, { ...state, x: left, y: bottom + apart }) : null
}

const append = (workspace: Workspace, state: State) =>
  Blockly.serialization.blocks.append(state, workspace, { recordUndo: true }) as Blockly.BlockSvg

/** Is there a block of this type that goes by the same name already? */
const isThere = (workspace: Workspace, { type, fields }: Template, name: string): boolean =>
  workspace.getBlocksByType(type).some((block) => block.getFieldValue(name) === fields?.[name])

/** Hangs a variable behind those of the program, unless it has one of this name. */
function declare(workspace: Workspace, variable: Template): void {
  if (isThere(workspace, variable, 'VAR')) return
  const [start] = workspace.getBlocksByType('robControls_start')
  const made = add(workspace, [variable])
  let last = start?.getInput('ST')?.connection
  for (let block = last?.targetBlock(); block; block = block.getNextBlock()) last = block.nextConnection
  if (last && made?.previousConnection) last.connect(made.previousConnection)
}
