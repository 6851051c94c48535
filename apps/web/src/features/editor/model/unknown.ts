import * as Blockly from 'blockly/core'
import type { Block } from '@botgarten/blocks'
import { plainId } from './ids.ts'
import type { UnknownBlock } from './program.ts'
import { unknownTypes } from './state.ts'

/** Blocks of types that this version does not know: grey, with their name, written back as they came. */
export function defineUnknownBlocks(): void {
  for (const [place, type] of Object.entries(unknownTypes)) {
    Blockly.Blocks[type] = behaviour(place === 'value')
  }
}

function behaviour(isValue: boolean) {
  return {
    init(this: UnknownBlock) {
      this.raw = { id: this.id, type: '?' }
      this.setStyle('unknown')
      this.appendDummyInput().appendField(new Blockly.FieldLabel('?'), 'NAME')
      if (isValue) return this.setOutput(true, null)
      this.setPreviousStatement(true)
      this.setNextStatement(true)
    },
    saveExtraState(this: UnknownBlock) {
      return { block: this.raw }
    },
    loadExtraState(this: UnknownBlock, { block }: { block: Block }) {
      // A copy has an id of its own; what hangs in it needs one too.
      this.raw = block.id === this.id ? block : { ...renamed(block), id: this.id }
      this.setFieldValue(block.type, 'NAME')
    },
  }
}

function renamed(block: Block): Block {
  const { values, statements } = block
  return {
    ...block,
    id: plainId(),
    ...(values && { values: mapped(values, renamed) }),
    ...(statements && { statements: mapped(statements, (row) => row.map(renamed)) }),
  }
}

const mapped = <Value>(record: { readonly [name: string]: Value }, change: (value: Value) => Value) =>
  Object.fromEntries(Object.entries(record).map(([name, value]) => [name, change(value)]))
