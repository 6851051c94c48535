import * as Blockly from 'blockly/core'
import type { Finding } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'
import { followMap } from '../model/map-ends.ts'
import { watchCopies, type Copy } from '../model/copies.ts'
import { followNeurons } from './follow.ts'
import { followGrowth } from './growth.ts'

export interface Reports {
  change(program: Program): void
  /** Blockly can undo one step more. */
  undoStep(): void
  select(id: string | null): void
  copied(pairs: readonly Copy[]): void
  /** A finding was pressed at its block. */
  finding(finding: Finding): void
}

/** What happens within this many milliseconds is one change for the page. */
const settle = 16

/** Tells the page what happens on the workspace; `emit` is called once for what changes within a frame. */
export function listen(workspace: Blockly.WorkspaceSvg, reports: Reports, emit: () => void): () => void {
  const copiesIn = watchCopies(workspace)
  const follow = followNeurons(workspace, () => workspace.isDragging())
  const grow = followGrowth(workspace)
  const ends = followMap(workspace)
  let group: string | null = null
  let waiting: ReturnType<typeof setTimeout> | undefined

  // A change during a drag is reported when the drag ends, whatever is dragged: only a dragged block fires an event then, and
  // a pressed background closes the field that is edited and moves the workspace.
  const soon = () => {
    waiting ??= setTimeout(() => {
      waiting = undefined
      if (workspace.isDragging()) soon()
      else emit()
    }, settle)
  }

  const hear = (event: Blockly.Events.Abstract) => {
    if (event instanceof Blockly.Events.Selected) reports.select(event.newElementId ?? null)
    follow(event)
    grow(event)
    ends(event)
    // What is still being typed is no number yet.
    if (event.isUiEvent || event instanceof Blockly.Events.BlockFieldIntermediateChange) return
    if (event.recordUndo && (event.group === '' || event.group !== group)) {
      group = event.group
      reports.undoStep()
    }
    const copies = copiesIn(event)
    if (copies.length > 0) reports.copied(copies)
    soon()
  }

  workspace.addChangeListener(hear)
  return () => {
    workspace.removeChangeListener(hear)
    if (waiting === undefined) return
    clearTimeout(waiting)
    emit()
  }
}

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
