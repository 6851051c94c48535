import * as Blockly from 'blockly/core'
import { addBlocks, type Block } from '@botgarten/blocks'
import { callBlock, expert, expertToolbox, variableBlocks } from '@botgarten/blocks/later'
import { knowTypes } from '../bot-block.ts'
import { keepWhatFilesJoin } from '../fits.ts'
import { knowComingParts } from '../shape.ts'
import { stateOfTemplate } from '../state.ts'
import { toolboxInfo } from '../toolbox.ts'
import { toProgram } from '../program.ts'
import type { Words } from '#lib/words/say.ts'
import { variablesOn } from './name-field.ts'
import { comingParts, typedOutput } from './parts.ts'

/** While a program is loaded (no events), what it joins stays joined. */
class Checker extends Blockly.ConnectionChecker {
  override doTypeChecks(a: Blockly.Connection, b: Blockly.Connection) {
    return !Blockly.Events.isEnabled() || super.doTypeChecks(a, b)
  }
}

/** Makes the whole language known to the editor; blocks that are drawn already are drawn anew by who calls this. */
export function learn(): void {
  addBlocks(expert)
  knowTypes(typedOutput)
  knowComingParts(comingParts)
  keepWhatFilesJoin()
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

const variables = 'BOTGARTEN_VARIABLES'
const functions = 'BOTGARTEN_FUNCTIONS'
const empty = { stacks: [], config: { stacks: [] } }

const inShelf = (template: Parameters<typeof stateOfTemplate>[0]) =>
  ({ kind: 'block', ...stateOfTemplate(template) }) as Blockly.utils.toolbox.FlyoutItemInfo

/** A new name for every variable that is taken from the shelf. */
function freeName(workspace: Blockly.Workspace, names: string): string {
  const taken = variablesOn(workspace).map(({ name }) => name)
  return [...names].find((name) => !taken.includes(name)) ?? `x${taken.length}`
}

function variableShelf(workspace: Blockly.Workspace): Blockly.utils.toolbox.FlyoutItemInfoArray {
  const name = freeName(workspace, 'xyzabcdefg')
  const fresh = { ...declaration, fields: { ...declaration.fields, VAR: name } }
  const uses = variablesOn(workspace).flatMap(({ name, type }) => variableBlocks(name, type))
  return [fresh, ...uses].map(inShelf)
}

function functionShelf(workspace: Blockly.Workspace): Blockly.utils.toolbox.FlyoutItemInfoArray {
  const plain = expertToolbox.find(({ category }) => category === 'functions')?.blocks ?? []
  const made: readonly Block[] = toProgram(workspace, empty).stacks.flatMap(({ blocks }) =>
    blocks.slice(0, 1),
  )
  const calls = made.map(callBlock).filter((call) => call !== null)
  return [...plain, parameter, ...calls].map(inShelf)
}

/** The shelf with everything; variables and functions follow the program. */
export function expertShelf(
  words: Words,
  workspace: Blockly.WorkspaceSvg,
): Blockly.utils.toolbox.ToolboxInfo {
  workspace.registerToolboxCategoryCallback(variables, variableShelf)
  workspace.registerToolboxCategoryCallback(functions, functionShelf)
  const info = toolboxInfo(words, expertToolbox)
  const row = (category: 'variables' | 'functions', custom: string) => ({
    kind: 'category',
    name: words(`category.${category}`),
    categorystyle: category,
    toolboxitemid: `shelf-${category}`,
    custom,
  })
  const contents = info.contents.flatMap((item) => {
    const id = 'toolboxitemid' in item ? item.toolboxitemid : ''
    if (id === 'shelf-lists') return [item, row('variables', variables)]
    return id === 'shelf-functions' ? [row('functions', functions)] : [item]
  })
  return { ...info, contents }
}
