import { definitions } from '@botgarten/blocks'
import * as Blockly from 'blockly/core'
import { beforeAll, expect, it } from 'vitest'
import { wordsIn } from '#words/message.ts'
import { defineBlocks } from '../shape.ts'
import { learn } from './expert.ts'

beforeAll(() => {
  learn()
  defineBlocks(Object.values(definitions), { words: wordsIn('en'), locale: 'en' })
})

/** Rows of a new block in order: the names of their fields, or of their input. */
function rowsOf(type: string): readonly string[] {
  const workspace = new Blockly.Workspace()
  const { inputList } = workspace.newBlock(type)
  const rows = inputList.map(({ name, fieldRow }) => [...fieldRow.map((field) => field.name ?? ''), name])
  workspace.dispose()
  return rows.map((names) => names.filter(Boolean).join(' ')).filter(Boolean)
}

it('names what goes into the mouth of the start block and of a function', () => {
  const workspace = new Blockly.Workspace()
  const labelOf = (type: string) =>
    workspace
      .newBlock(type)
      .getInput('ST')
      ?.fieldRow.map((field) => field.getText())
  expect(labelOf('robControls_start')).toEqual(['variables'])
  expect(labelOf('robProcedures_defreturn')).toEqual(['parameters'])
  workspace.dispose()
})

it('keeps a function’s parameters behind its name, also where a field of the block is built later', () => {
  expect(rowsOf('robProcedures_defreturn')).toEqual(['NAME TYPE ST_ANCHOR', 'ST', 'STACK', 'RETURN'])
  expect(rowsOf('robProcedures_defnoreturn')).toEqual(['NAME ST_ANCHOR', 'ST', 'STACK'])
})
