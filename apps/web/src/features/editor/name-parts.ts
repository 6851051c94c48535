import type * as Blockly from 'blockly/core'
import type { Words } from '#words/say.ts'

/** Blockly leaves its frame and its shelf without names, and counts only what it saw coming. */
export function nameParts(workspace: Blockly.WorkspaceSvg, words: Words): void {
  const frame = workspace.getInjectionDiv()
  frame.setAttribute('aria-label', words('editor.blocks'))
  frame.querySelector('.blocklyToolbox [role=tree]')?.setAttribute('aria-label', words('editor.toolbox'))
  workspace.setInitialAriaContext()
}
