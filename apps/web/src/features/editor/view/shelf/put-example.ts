import * as Blockly from 'blockly/core'
import { stacksOf, type Template } from '@botgarten/blocks'
import { grouped } from '../../model/list.ts'
import { stateOfRow, type State } from '../../model/state.ts'
import { show } from './put.ts'

type Paper = Blockly.WorkspaceSvg

/** Further from what is above than Blockly lets blocks snap. */
const apart = 60

/** Lays an example's blocks below all others; its variables are made where the program makes its own. One step of undo. */
export function putExample(paper: Paper, example: readonly Template[]): void {
  grouped(() => {
    const [row = [], ...functions] = stacksOf(example)
    const [start, ...rest] = row
    for (const made of start?.statements?.['ST'] ?? []) declare(paper, made)
    const first = add(paper, rest)
    for (const made of functions) if (!isThere(paper, made[0]!, 'NAME')) add(paper, made)
    if (first) void show(paper, first)
  })
}

function add(paper: Paper, row: readonly Template[]): Blockly.BlockSvg | null {
  const state = stateOfRow(row, [], true)
  const { left, bottom } = paper.getBlocksBoundingBox()
  return state ? append(paper, { ...state, x: left, y: bottom + apart }) : null
}

const append = (paper: Paper, state: State) =>
  Blockly.serialization.blocks.append(state, paper, { recordUndo: true }) as Blockly.BlockSvg

/** Is there a block of this type that goes by the same name already? */
const isThere = (paper: Paper, { type, fields }: Template, name: string): boolean =>
  paper.getBlocksByType(type).some((block) => block.getFieldValue(name) === fields?.[name])

/** Hangs a variable behind those of the program, unless it has one of this name. */
function declare(paper: Paper, variable: Template): void {
  if (isThere(paper, variable, 'VAR')) return
  const [start] = paper.getBlocksByType('robControls_start')
  const made = add(paper, [variable])
  let last = start?.getInput('ST')?.connection
  for (let block = last?.targetBlock(); block; block = block.getNextBlock()) last = block.nextConnection
  if (last && made?.previousConnection) last.connect(made.previousConnection)
}
