import * as Blockly from 'blockly/core'

/** Escape that closes something of Blockly's stays here; any other reaches the page, where it stops the robot. */
export function keepEscape(host: HTMLElement, workspace: Blockly.WorkspaceSvg): () => void {
  let closing = false
  const before = (event: KeyboardEvent) => {
    if (event.key === 'Escape') closing = somethingIsOpen(workspace)
  }
  const after = (event: KeyboardEvent) => {
    if (event.key === 'Escape' && closing) event.stopPropagation()
  }
  host.addEventListener('keydown', before, { capture: true })
  host.addEventListener('keydown', after)
  return () => {
    host.removeEventListener('keydown', before, { capture: true })
    host.removeEventListener('keydown', after)
  }
}

function somethingIsOpen(workspace: Blockly.WorkspaceSvg): boolean {
  const flyout = workspace.getFlyout()
  return (
    workspace.isDragging() ||
    flyout?.isVisible() === true ||
    Blockly.WidgetDiv.isVisible() ||
    Blockly.DropDownDiv.isVisible()
  )
}
