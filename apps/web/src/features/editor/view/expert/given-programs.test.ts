import { definitions, type Block } from '@botgarten/blocks'
import { readOpenRoberta } from '@botgarten/programs/open-roberta'
import * as Blockly from 'blockly/core'
import { readdirSync, readFileSync } from 'node:fs'
import { beforeAll, expect, it } from 'vitest'
import { toProgram, toWorkspace } from '../../model/program.ts'
import { defineBlocks } from '../shape.ts'
import { defineUnknownBlocks } from '../../model/unknown.ts'
import { wordsIn } from '#words/message.ts'
import { learn } from './expert.ts'

const folder = new URL(
  '../../../../../../../packages/programs/testing/open-roberta/programs/',
  import.meta.url,
)

beforeAll(() => {
  learn()
  defineBlocks(Object.values(definitions), { words: wordsIn('en'), locale: 'en' })
  defineUnknownBlocks()
})

/** Of every block: its type, fields, comment and state, and where its inner blocks sit. */
const flat = (block: Block): unknown => ({
  ...block,
  values: Object.fromEntries(Object.entries(block.values ?? {}).map(([name, child]) => [name, flat(child)])),
  statements: Object.fromEntries(
    Object.entries(block.statements ?? {}).flatMap(([name, rows]) =>
      rows.length > 0 ? [[name, rows.map(flat)]] : [],
    ),
  ),
})

it.each(readdirSync(folder))('%s comes back from the workspace as it went there', (file) => {
  const program = readOpenRoberta(readFileSync(new URL(file, folder), 'utf8'))
  const workspace = new Blockly.Workspace()
  toWorkspace(program, workspace)
  const stacks = toProgram(workspace, program).stacks
  workspace.dispose()
  expect(stacks.map(({ blocks }) => blocks.map(flat))).toEqual(
    program.stacks.map(({ blocks }) => blocks.map(flat)),
  )
})
