import * as Blockly from 'blockly/core'
import { toolbox, type Template } from '@botgarten/blocks'
import type { CardNetwork, CardNeuron } from '@botgarten/content'
import { reachedIn, spotIn, type Program } from '@botgarten/programs'
import { grouped } from './list.ts'
import { toProgram } from './program.ts'
import { stateOfTemplate } from './state.ts'

const networkType = 'ai_neural_network'
const startType = 'robControls_start'
const foreverType = 'robControls_loopForever'
const switchedOff = 'MANUALLY_DISABLED'

/** The network in a block, or below it. */
export const networkIn = (block: Blockly.Block): Blockly.Block | undefined =>
  block.getDescendants(false).find(({ type }) => type === networkType)

export const holdsNetwork = (block: Blockly.Block): boolean => networkIn(block) !== undefined

/**
 * Puts a block, with all that hangs with it, among those that run: a network into the loop, other blocks below the start
 * block. What is missing is made. One step of undo.
 */
export function putIn(workspace: Blockly.Workspace, base: Program, id: string): void {
  const block = workspace.getBlockById(id)
  if (!block) return
  grouped(() => {
    if (spotIn(toProgram(workspace, base)).start === null) makeStart(workspace, block)
    const program = toProgram(workspace, base)
    if (reachedIn(program).has(id)) return
    const { start, loop } = spotIn(program)
    const begin = workspace.getBlockById(start ?? '')
    if (!begin) return
    const stack = takeOut(block)
    const body = bodyOf(workspace.getBlockById(loop ?? ''))
    if (block.type !== networkType) hang(stack, begin.nextConnection)
    else if (body) atEnd(stack, body)
    else if (standsInLoop(block)) atEnd(stack, begin.nextConnection)
    else {
      const made = make(workspace, foreverType)
      atEnd(stack, bodyOf(made))
      atEnd(made, begin.nextConnection)
    }
  })
}

/**
 * Makes a network and puts it below the block that a card names, else into the loop. One step of undo.
 * @param wanted the network of the card; absent: the one of the toolbox
 * @returns the id of its block
 */
export function putNetworkIn(workspace: Blockly.Workspace, base: Program, wanted?: CardNetwork): string {
  return grouped(() => {
    const made = wanted ? append(workspace, templateOf(wanted)) : make(workspace, networkType)
    const { below = '' } = wanted ?? {}
    if (reachedIn(base).has(below)) hang(made, workspace.getBlockById(below)?.nextConnection ?? null)
    else putIn(workspace, base, made.id)
    return made.id
  })
}

const templateOf = ({ inputs, outputs }: CardNetwork): Template => ({
  type: networkType,
  values: { INPUT_LAYER: layerOf('InputNode', inputs), OUTPUT_LAYER: layerOf('OutputNode', outputs) },
})

const layerOf = (kind: 'InputNode' | 'OutputNode', neurons: readonly CardNeuron[]): Template => ({
  type: 'ai_easy_list',
  mutation: { attrs: { items: String(neurons.length), list_type: kind } },
  values: Object.fromEntries(neurons.map((neuron, index) => [`ADD${index}`, neuron])),
})

/** Switches a block on, and what it stands in. One step of undo. */
export function switchOn(workspace: Blockly.Workspace, id: string): void {
  grouped(() => {
    for (let block = workspace.getBlockById(id); block; block = block.getSurroundParent())
      block.setDisabledReason(false, switchedOff)
  })
}

/** What goes together: the whole stack, or the block alone where that stack begins with one that cannot hang below others. */
function takeOut(block: Blockly.Block): Blockly.Block {
  const root = block.getRootBlock()
  if (root.previousConnection) return root
  block.unplug(true)
  return block
}

/** A start block that was switched off is switched on, else one is made where the stack lies. */
function makeStart(workspace: Blockly.Workspace, block: Blockly.Block): void {
  const there = workspace.getBlocksByType(startType, false)[0]
  if (there) return there.setDisabledReason(false, switchedOff)
  const { x, y } = block.getRootBlock().getRelativeToSurfaceXY()
  make(workspace, startType).moveBy(x, y)
}

function make(workspace: Blockly.Workspace, type: string): Blockly.Block {
  const template = toolbox.flatMap(({ blocks }) => blocks).find((block) => block.type === type) ?? { type }
  return append(workspace, template)
}

const append = (workspace: Blockly.Workspace, template: Template): Blockly.Block =>
  Blockly.serialization.blocks.append(stateOfTemplate(template), workspace, { recordUndo: true })

const bodyOf = (loop: Blockly.Block | null): Blockly.Connection | null =>
  loop?.inputList.find(({ type }) => type === Blockly.inputs.inputTypes.STATEMENT)?.connection ?? null

/** Does the block stand in a loop of its stack that never ends? */
function standsInLoop(block: Blockly.Block): boolean {
  for (let at = block.getSurroundParent(); at; at = at.getSurroundParent())
    if (at.type === foreverType) return true
  return false
}

/** Behind the last block that hangs there; before one behind which nothing can. */
function atEnd(stack: Blockly.Block, first: Blockly.Connection | null): void {
  let last = first
  for (let next = last?.targetBlock(); next?.nextConnection; next = last?.targetBlock())
    last = next.nextConnection
  hang(stack, last)
}

/** What hung there hangs behind the stack then. */
function hang(stack: Blockly.Block, at: Blockly.Connection | null): void {
  if (at && stack.previousConnection) at.connect(stack.previousConnection)
}
