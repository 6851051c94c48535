import * as Blockly from 'blockly/core'
import { hiddenType, toolbox, type Category, type ToolboxCategory } from '@botgarten/blocks'
import { stateOfTemplate } from '../../model/state.ts'
import type { Words } from '#words/message.ts'

/** What the toolbox holds: a category a row, its blocks with their presets plugged in. Hidden layers come with their level. */
export function toolboxInfo(
  words: Words,
  categories: readonly ToolboxCategory[] = toolbox,
  without: string = hiddenType,
): Blockly.utils.toolbox.ToolboxInfo {
  return {
    kind: 'categoryToolbox',
    contents: categories.map(({ category, blocks }) => ({
      kind: 'category',
      name: words(`category.${category}`),
      categorystyle: category,
      toolboxitemid: `shelf-${category}`,
      contents: blocks
        .filter(({ type }) => type !== without)
        .map((template) => ({ kind: 'block', ...stateOfTemplate(template) })),
    })),
  }
}

/** The rows of some families; null: all of them. */
export function only(
  info: Blockly.utils.toolbox.ToolboxInfo,
  families: readonly Category[] | null,
): Blockly.utils.toolbox.ToolboxInfo {
  if (!families) return info
  const ids = families.map((family) => `shelf-${family}`)
  const isOffered = (row: object) => 'toolboxitemid' in row && ids.includes(String(row.toolboxitemid))
  return { ...info, contents: info.contents.filter(isOffered) }
}

/** A row of the toolbox: a coloured circle above its word; the chosen one in a box of its colour. */
class ToolboxRow extends Blockly.ToolboxCategory {
  protected override createDom_() {
    const row = super.createDom_()
    row.style.setProperty('--category', this.colour_)
    // Clicks on the words belong to the row (the toolbox finds a row by the id of the click's target).
    if (this.rowDiv_) this.rowDiv_.style.pointerEvents = 'none'
    return row
  }

  /** The row itself, which carries the id already: no second element may have it. */
  override getClickTarget() {
    return this.htmlDiv_ as Element
  }

  protected override createIconDom_() {
    const dot = document.createElement('span')
    dot.className = 'editor-toolbox-dot'
    return dot
  }

  protected override addColourBorder_() {}

  override setSelected(selected: boolean) {
    this.rowDiv_?.classList.toggle('blocklyToolboxSelected', selected)
    if (this.htmlDiv_) Blockly.utils.aria.setState(this.htmlDiv_, Blockly.utils.aria.State.SELECTED, selected)
  }
}

/** Escape closes what is open and is heard by the page where nothing is. */
class Toolbox extends Blockly.Toolbox {
  protected override onKeyDown_(event: KeyboardEvent) {
    if (event.key === 'Escape' && !this.getFlyout()?.isVisible()) return
    super.onKeyDown_(event)
  }
}

const smallestShare = 0.8

/**
 * Where a row's blocks lie. Blockly 13.3 lets each of them own its connections for a screen reader (`aria-owns`), some
 * of which are not in the page, and gives those a role that a list of options may not hold. Nobody can go to a
 * connection of a block on the toolbox: they are hidden from readers instead.
 */
class ToolboxFlyout extends Blockly.VerticalFlyout {
  /** A row whose widest block has no room beside the toolbox is shown smaller, as far as it can still be read. */
  override getFlyoutScale(): number {
    const { scale } = this.targetWorkspace
    const widths = this.getContents().map((item) => item.getElement().getBoundingRectangle().getWidth())
    const needed = Math.max(0, ...widths) + this.MARGIN * 1.5 + this.tabWidth_
    const room = this.targetWorkspace.getMetrics().viewWidth - Blockly.Scrollbar.scrollbarThickness
    return Math.min(scale, Math.max(room / needed, scale * smallestShare))
  }

  override show(contents: Parameters<Blockly.VerticalFlyout['show']>[0]) {
    super.show(contents)
    void Blockly.renderManagement
      .finishQueuedRenders()
      .then(() => hideConnections(this.getWorkspace().getCanvas()))
  }
}

function hideConnections(canvas: Element) {
  for (const block of canvas.querySelectorAll('[aria-owns]')) block.removeAttribute('aria-owns')
  for (const connection of canvas.querySelectorAll('.blocklyHighlightedConnectionPath')) {
    connection.setAttribute('role', 'none')
    connection.removeAttribute('aria-roledescription')
    connection.setAttribute('aria-hidden', 'true')
  }
}

export const toolboxPlugins = { toolbox: Toolbox, flyoutsVerticalToolbox: ToolboxFlyout }

export function registerToolbox(): void {
  Blockly.registry.register(
    Blockly.registry.Type.TOOLBOX_ITEM,
    Blockly.ToolboxCategory.registrationName,
    ToolboxRow,
    true,
  )
}
