import * as Blockly from 'blockly/core'
import { addBlocks, type Block, type Template, type ToolboxCategory } from '@botgarten/blocks'
import { callBlock, expert, expertToolbox, variableBlocks } from '@botgarten/blocks/packs/expert'
import { knowTypes } from '../../model/bot-block.ts'
import { keepWhatFilesJoin } from '../../model/fits.ts'
import { knowComingParts } from '../shape.ts'
import { stateOfTemplate } from '../../model/state.ts'
import { toolboxInfo } from '../toolbox/info.ts'
import { toProgram } from '../../model/program.ts'
import { defineUnknownBlocks } from '../../model/unknown.ts'
import type { Words } from '#words/message.ts'
import { variablesOn } from './name-field.ts'
import { comingParts, typedOutput } from './parts.ts'

/** While a program is loaded (no events), what it joins stays joined. */
class Checker extends Blockly.ConnectionChecker {
  override doTypeChecks(a: Blockly.Connection, b: Blockly.Connection) {
    return !Blockly.Events.isEnabled() || super.doTypeChecks(a, b)
  }
}

/** Makes the whole language known to the editor; blocks that are drawn already are drawn again by who calls this. */
export function learn(): void {
  addBlocks(expert)
  knowTypes(typedOutput)
  knowComingParts(comingParts)
  keepWhatFilesJoin()
  defineUnknownBlocks()
  const { CONNECTION_CHECKER } = Blockly.registry.Type
  Blockly.registry.register(CONNECTION_CHECKER, Blockly.registry.DEFAULT, Checker, true)
}

const declaration = {
  type: 'robGlobalVariables_declare',
  mutation: { attrs: { next: 'false', declaration_type: 'Number' } },
  fields: { VAR: 'x', TYPE: 'Number' },
  values: { VALUE: { type: 'math_number', fields: { NUM: '0' } } },
}
const parameter = {
  type: 'robLocalVariables_declare',
  mutation: { attrs: { next: 'false', declaration_type: 'Number' } },
  fields: { VAR: 'n', TYPE: 'Number' },
}

const empty = { stacks: [], config: { stacks: [] } }

const inToolbox = (template: Template) =>
  ({ kind: 'block', ...stateOfTemplate(template) }) as Blockly.utils.toolbox.FlyoutItemInfo

/** A new name for every variable that is taken from the toolbox. */
function freeName(workspace: Blockly.Workspace, names: string): string {
  const taken = variablesOn(workspace).map(({ name }) => name)
  return [...names].find((name) => !taken.includes(name)) ?? `x${taken.length}`
}

function variableBlocksOn(workspace: Blockly.Workspace): readonly Template[] {
  const name = freeName(workspace, 'xyzabcdefg')
  const fresh = { ...declaration, fields: { ...declaration.fields, VAR: name } }
  const uses = variablesOn(workspace).flatMap(({ name, type }) => variableBlocks(name, type))
  return [fresh, ...uses]
}

function functionBlocksOn(workspace: Blockly.Workspace): readonly Template[] {
  const plain = expertToolbox.find(({ category }) => category === 'functions')?.blocks ?? []
  const made: readonly Block[] = toProgram(workspace, empty).stacks.flatMap(({ blocks }) =>
    blocks.slice(0, 1),
  )
  const calls = made.map(callBlock).filter((call) => call !== null)
  return [...plain, parameter, ...calls]
}

/** All that the toolbox with everything offers for the program on a workspace. */
export const everything = (workspace: Blockly.Workspace): readonly ToolboxCategory[] =>
  expertToolbox.flatMap((row) => {
    if (row.category === 'functions') return [{ ...row, blocks: functionBlocksOn(workspace) }]
    const variables = { category: 'variables', blocks: variableBlocksOn(workspace) } as const
    return row.category === 'lists' ? [row, variables] : [row]
  })

/** Rows of the toolbox that follow the program. */
const following = ['variables', 'functions']

/** The toolbox with everything. */
export function toolboxOf(words: Words, workspace: Blockly.WorkspaceSvg): Blockly.utils.toolbox.ToolboxInfo {
  const rows = everything(workspace)
  for (const name of following)
    workspace.registerToolboxCategoryCallback(name, (on) =>
      everything(on as Blockly.Workspace).flatMap(({ category, blocks }) =>
        category === name ? blocks.map(inToolbox) : [],
      ),
    )
  const { kind, contents } = toolboxInfo(words, rows, '')
  const custom = (k: number) => following.find((name) => rows[k]?.category === name)
  return { kind, contents: contents.map((item, k) => (custom(k) ? { ...item, custom: custom(k)! } : item)) }
}
