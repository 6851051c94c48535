import * as Blockly from 'blockly/core'
import type { Template } from '@botgarten/blocks'
import { faceOf, type BotBlock } from './bot-block.ts'
import { ButtonField } from '../view/button-field.ts'
import { freshNeuron } from './fresh.ts'
import { stateOfTemplate } from './state.ts'
import type { Words } from '#words/message.ts'

/** The socket at the foot of a list: what is dropped there gets a line of its own. */
export const foot = 'FOOT'
const adder = 'ADDER'
const adderLabel = 'ADDER_LABEL'
const tail = (line: string) => `${line}_END`
const minusOf = (line: string) => `${line}_MINUS`

/** Names of the inputs of a growing list, from the top. */
export const linesOf = (block: BotBlock): readonly string[] => block.extra.lines ?? []

/** Gives a growing list its first lines; the extra state brings the others. */
export function buildList(block: BotBlock, words: Words): void {
  const { items } = block.definition.look
  if (!items) return
  const names = Array.from({ length: items.min }, (_, at) => `${items.prefix}${at}`)
  block.extra = { ...block.extra, lines: names }
  matchLines(block, words)
}

/** Brings the inputs of a growing list in line with its state. Lines that stay are not touched. */
export function matchLines(block: BotBlock, words: Words): void {
  const { items } = block.definition.look
  if (!items) return
  const lines = linesOf(block)
  const stale = block.inputList.filter(({ name }) => isLine(name, items.prefix) && !lines.includes(name))
  for (const { name } of stale) {
    block.removeInput(tail(name))
    block.removeInput(name)
  }
  matchFoot(block, words)
  const accepts = acceptedBy(block)
  for (const line of lines) {
    if (!block.getInput(line)) appendLine(block, line, words)
    block.getInput(line)?.setCheck(accepts)
    block.moveInputBefore(line, foot)
    block.moveInputBefore(tail(line), foot)
  }
  for (const name of [foot, adder]) block.getInput(name)?.setVisible(lines.length < items.max)
}

/** What a line takes; null: anything. */
function acceptedBy(block: BotBlock): string[] | null {
  const accepts = faceOf(block)?.items?.accepts ?? block.definition.look.items?.accepts
  return accepts ? [...accepts] : null
}

const isLine = (name: string, prefix: string) => new RegExp(`^${prefix}\\d+$`).test(name)

function appendLine(block: BotBlock, line: string, words: Words) {
  block.appendValueInput(line)
  const minus = new ButtonField('minus', words('editor.remove-line'), () => removeLine(block, line))
  block.appendEndRowInput(tail(line)).appendField(minus, minusOf(line))
}

function matchFoot(block: BotBlock, words: Words) {
  const items = faceOf(block)?.items
  const label = words(items?.add ?? 'editor.add-line')
  if (block.getField(adderLabel)?.getText() === label) return
  block.removeInput(adder, true)
  block.removeInput(foot, true)
  // It is no row of its own: readers say the plus beside it instead.
  block.appendValueInput(foot).setCheck(acceptedBy(block)).getLabel = () => ''
  const input = block.appendDummyInput(adder)
  input.appendField(new ButtonField('plus', label, () => addLine(block)), 'PLUS')
  input.appendField(new Blockly.FieldLabel(label), adderLabel)
}

/** Adds a line with a neuron in it: `template`, or what the list comes with at its next free port. */
export function addLine(
  block: BotBlock,
  template: Template | null = freshNeuron(block),
): Blockly.Block | null {
  return grouped(() => {
    const line = openLine(block)
    return line !== null && template ? plugIn(block, line, template) : null
  })
}

/** A new empty line at the end; null where the list is full. */
export function openLine(block: BotBlock): string | null {
  const { items } = block.definition.look
  const lines = linesOf(block)
  if (!items || lines.length >= items.max) return null
  const line = freeName(lines, items.prefix)
  reshape(block, [...lines, line])
  return line
}

/** Takes a line out with what stands in it; the last one only empties. The other lines' blocks are not touched. */
export function removeLine(block: BotBlock, line: string): void {
  const lines = linesOf(block)
  const next = lines[lines.indexOf(line) + 1]
  grouped(() => {
    block.getInputTargetBlock(line)?.dispose(false)
    closeLine(block, line)
  })
  focusButton(block, linesOf(block).includes(line) ? minusOf(line) : next ? minusOf(next) : 'PLUS')
}

/** Takes an empty line out, unless the list must keep it. */
export function closeLine(block: BotBlock, line: string): void {
  const { items } = block.definition.look
  const others = linesOf(block).filter((other) => other !== line)
  if (items && others.length >= items.min && !block.getInputTargetBlock(line)) reshape(block, others)
}

/** The button that was pressed is gone: the keyboard goes on from its neighbour. */
function focusButton(block: BotBlock, name: string) {
  const field = block.getField(name)
  if (field?.getSvgRoot()) Blockly.getFocusManager().focusNode(field)
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

/** Sets the lines as one change that Blockly can undo. */
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
