import type * as Blockly from 'blockly/core'

/** Blockly's name for what is written on a folded block. */
const written = '_TEMP_COLLAPSED_FIELD'
/** Of an input that holds statements: Blockly's number for it. */
const statement: Blockly.inputs.inputTypes = 3

/** What a folded block says: its own words up to the blocks that stand in it, and that there are some. */
export function phraseOf(block: Blockly.Block): string {
  const own = block.inputList.filter(({ fieldRow }) => fieldRow.every(({ name }) => name !== written))
  const first = own.findIndex(({ type }) => type === statement)
  const words = own
    .slice(0, first < 0 ? own.length : first)
    .flatMap(({ fieldRow, connection }) => [
      ...fieldRow.map((field) => field.getText().trim()),
      connection?.targetBlock()?.toString() ?? '',
    ])
  return [...words.filter(Boolean), ...(first < 0 ? [] : ['…'])].join(' ')
}

/** Folded blocks say a whole phrase: Blockly asks them whenever it draws them, for as many letters as fit. */
export function tellFolded(workspace: Blockly.WorkspaceSvg): void {
  for (const block of workspace.getAllBlocks(false).filter((one) => one.isCollapsed())) {
    block.toString = () => phraseOf(block)
    block.render()
  }
}
