import * as Blockly from 'blockly/core'
import type { Template } from '@botgarten/blocks'
import { faceOf, type BotBlock } from './bot-block.ts'
import { ButtonField } from './button-field.ts'
import { freshNeuron } from './fresh.ts'
import { stateOfTemplate } from './state.ts'
import type { Words } from './words.ts'

const foot = 'FOOT'
const tail = (line: string) => `${line}_END`

/** Names of the inputs of a growing list, from the top. */
export const linesOf = (block: BotBlock): readonly string[] => block.extra.lines ?? []

/** Builds the foot of a growing list. Its lines come with the extra state. */
export function buildList(block: BotBlock, words: Words): void {
  const { items } = block.definition.look
  if (!items) return
  const names = Array.from({ length: items.min }, (_, at) => `${items.prefix}${at}`)
  block.extra = { ...block.extra, lines: names }
  matchLines(block, words)
}

/** Brings the inputs of a growing list in line with its state; what is plugged in elsewhere stays. */
export function matchLines(block: BotBlock, words: Words): void {
  const { items } = block.definition.look
  if (!items) return
  const lines = linesOf(block)
  const stale = block.inputList.filter(({ name }) => isLine(name, items.prefix) && !lines.includes(name))
  for (const { name } of stale) {
    block.removeInput(name)
    block.removeInput(tail(name))
  }
  makeFoot(block, words)
  for (const line of lines) if (!block.getInput(line)) appendLine(block, line, words)
  for (const line of lines) {
    block.moveInputBefore(line, foot)
    block.moveInputBefore(tail(line), foot)
    block.getInput(line)?.setCheck([...(faceOf(block)?.items?.accepts ?? [])])
    block.getInput(tail(line))?.setVisible(lines.length > items.min)
  }
  block.getInput(foot)?.setVisible(lines.length < items.max)
}

const isLine = (name: string, prefix: string) => new RegExp(`^${prefix}\\d+$`).test(name)

function appendLine(block: BotBlock, line: string, words: Words) {
  block.appendValueInput(line)
  const minus = new ButtonField('minus', words('editor.remove-line'), () => removeLine(block, line))
  block.appendEndRowInput(tail(line)).appendField(minus)
}

function makeFoot(block: BotBlock, words: Words) {
  block.removeInput(foot, true)
  const label = words(faceOf(block)?.items?.add ?? 'editor.add-line')
  const plus = new ButtonField('plus', label, () => addLine(block))
  block.appendDummyInput(foot).appendField(plus).appendField(new Blockly.FieldLabel(label))
}

/** Adds a line with a neuron in it: `template`, or what the list comes with at its next free port. */
export function addLine(
  block: BotBlock,
  template: Template | null = freshNeuron(block),
): Blockly.Block | null {
  const { items } = block.definition.look
  const lines = linesOf(block)
  if (!items || lines.length >= items.max) return null
  return grouped(() => {
    const line = freeName(lines, items.prefix)
    reshape(block, [...lines, line])
    return template && plugIn(block, line, template)
  })
}

/** Takes a line out with what stands in it. The blocks of the other lines are not touched. */
export function removeLine(block: BotBlock, line: string): void {
  grouped(() => {
    block.getInputTargetBlock(line)?.dispose(false)
    reshape(
      block,
      linesOf(block).filter((other) => other !== line),
    )
  })
}

function freeName(lines: readonly string[], prefix: string): string {
  for (let at = 0; ; at++) if (!lines.includes(prefix + at)) return prefix + at
}

/** Makes a block from its template in a free socket. */
export function plugIn(block: BotBlock, line: string, template: Template): Blockly.Block | null {
  const state = stateOfTemplate(template)
  const neuron = Blockly.serialization.blocks.append(state, block.workspace, { recordUndo: true })
  const socket = block.getInput(line)?.connection
  if (socket && neuron.outputConnection) socket.connect(neuron.outputConnection)
  return neuron
}

/** Sets the lines as one change that Blockly can take back. */
function reshape(block: BotBlock, lines: readonly string[]) {
  const before = JSON.stringify(block.saveExtraState?.())
  block.loadExtraState?.({ ...block.extra, lines })
  const after = JSON.stringify(block.saveExtraState?.())
  const Change = Blockly.Events.get(Blockly.Events.BLOCK_CHANGE)
  Blockly.Events.fire(new Change(block, 'mutation', null, before, after))
}

/** Carries out `change` as one step of undo. */
export function grouped<Result>(change: () => Result): Result {
  const outer = Blockly.Events.getGroup()
  if (!outer) Blockly.Events.setGroup(true)
  try {
    return change()
  } finally {
    Blockly.Events.setGroup(outer)
  }
}
