import { addBlocks, definitions, type Block } from '@botgarten/blocks'
import { learning, learningToolbox } from '@botgarten/blocks/packs/learning'
import type { Program } from '@botgarten/programs'
import * as Blockly from 'blockly/core'
import { vi } from 'vitest'
import type { BotBlock } from './bot-block.ts'
import { toProgram, toWorkspace } from './program.ts'
import { defineBlocks } from '../view/shape.ts'
import { defineUnknownBlocks } from './unknown.ts'
import { wordsIn } from '#words/message.ts'

addBlocks(learning, learningToolbox)

/** For tests: a workspace without a screen that shows a program. Blockly's events wait for a fake clock. */
export class Bench {
  readonly workspace = new Blockly.Workspace()
  readonly #base: Program

  constructor(...blocks: readonly Block[]) {
    vi.useFakeTimers()
    defineBlocks(Object.values(definitions), { words: wordsIn('en'), locale: 'en' })
    defineUnknownBlocks()
    this.#base = { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
    toWorkspace(this.#base, this.workspace)
  }

  /** One stack more, as if it were there from the beginning. */
  adds(...blocks: readonly Block[]): void {
    toWorkspace({ ...this.#base, stacks: [{ x: 0, y: 500, blocks }] }, this.workspace)
  }

  block(id: string): BotBlock {
    return this.workspace.getBlockById(id) as BotBlock
  }

  /** Lets Blockly tell its listeners what has happened. */
  settle(): void {
    vi.runAllTimers()
  }

  undo(): void {
    this.workspace.undo(false)
    this.settle()
  }

  redo(): void {
    this.workspace.undo(true)
    this.settle()
  }

  program(): Program {
    return toProgram(this.workspace, this.#base)
  }

  dispose(): void {
    this.workspace.dispose()
    // An event that stays in Blockly's queue would keep it from waking up again.
    this.settle()
    vi.useRealTimers()
  }
}

export const distance = (id: string, port: string): Block => ({
  id,
  type: 'ai_nn_input_node_ultrasonic',
  fields: { INPUTNODE: `ULTRASONIC_PORT_${port}` },
})

export const motor = (id: string, port: string): Block => ({
  id,
  type: 'ai_nn_output_node',
  fields: { OUTPUTNODE: `MOTORPORT_${port}` },
})

const list = (id: string, type: 'InputNode' | 'OutputNode', ...neurons: readonly Block[]): Block => ({
  id,
  type: 'ai_easy_list',
  mutation: { attrs: { items: String(neurons.length), list_type: type } },
  values: Object.fromEntries(neurons.map((neuron, at) => [`ADD${at}`, neuron])),
})

export const network = (inputs: readonly Block[], outputs: readonly Block[]): Block => ({
  id: 'net',
  type: 'ai_neural_network',
  values: {
    INPUT_LAYER: list('inputs', 'InputNode', ...inputs),
    OUTPUT_LAYER: list('outputs', 'OutputNode', ...outputs),
  },
})
