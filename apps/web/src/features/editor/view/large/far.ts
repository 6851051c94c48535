import * as Blockly from 'blockly/core'
import { awaited } from '../../model/program.ts'

/** With fewer blocks on the workspace all of them are drawn. */
const many = 300
/** Of the view's height and width: as much is drawn around it, so that scrolling finds its next blocks drawn. */
const around = 0.3
const hidden = 'editor-far'
/** Blocks of which only what follows them is drawn. */
const passed = new WeakSet<Blockly.BlockSvg>()

interface View {
  readonly top: number
  readonly bottom: number
  readonly left: number
  readonly right: number
}

function viewOf(workspace: Blockly.WorkspaceSvg): View {
  const { top, left, width, height } = workspace.getMetricsManager().getViewMetrics(true)
  const [more, wider] = [height * around, width * around]
  return { top: top - more, bottom: top + height + more, left: left - wider, right: left + width + wider }
}

/** Draws of a large program what is near the view: the browser neither lays out nor paints the rest. */
export function hideFar(workspace: Blockly.WorkspaceSvg): {
  readonly see: () => void
  readonly stop: () => void
} {
  let waiting = 0
  const see = () => {
    waiting = 0
    const all = !awaited.has(workspace) && workspace.getAllBlocks(false).length <= many
    const view = viewOf(workspace)
    const kept = keptFor(focusedOn(workspace))
    for (const top of workspace.getTopBlocks(false)) seeRow(top, all ? null : view, kept)
  }
  const soon = () => void (waiting ||= requestAnimationFrame(see))
  const whileDragged = () => workspace.isDragging() && soon()
  const host = workspace.getInjectionDiv()
  const forget = showBeforeFocus(soon)
  workspace.addChangeListener(soon)
  addEventListener('pointermove', whileDragged)
  const resized = new ResizeObserver(soon)
  resized.observe(host)
  return {
    see,
    stop() {
      cancelAnimationFrame(waiting)
      workspace.removeChangeListener(soon)
      removeEventListener('pointermove', whileDragged)
      resized.disconnect()
      forget()
    },
  }
}

/** What stays for the block that has the keyboard: `chain` is all that it hangs in or on, `shown` what is drawn of it. */
interface Kept {
  readonly chain: ReadonlySet<Blockly.BlockSvg>
  readonly shown: ReadonlySet<Blockly.BlockSvg>
}

function keptFor(block: Blockly.BlockSvg | null): Kept {
  const chain = new Set<Blockly.BlockSvg>()
  const shown = new Set<Blockly.BlockSvg>()
  for (let one = block; one; one = one.getParent()) chain.add(one)
  for (let one = block; one; one = one.getSurroundParent()) shown.add(one)
  return { chain, shown }
}

function blockOf(node: Blockly.IFocusableNode | null): Blockly.BlockSvg | null {
  if (node instanceof Blockly.BlockSvg) return node
  const source =
    node instanceof Blockly.Field || node instanceof Blockly.icons.Icon ? node.getSourceBlock() : null
  return source instanceof Blockly.BlockSvg ? source : null
}

function focusedOn(workspace: Blockly.WorkspaceSvg): Blockly.BlockSvg | null {
  const block = blockOf(Blockly.getFocusManager().getFocusedNode())
  return block?.workspace === workspace ? block : null
}

/** A row of blocks from its first; without a view everything is shown. */
function seeRow(first: Blockly.BlockSvg, view: View | null, kept: Kept) {
  for (let block: Blockly.BlockSvg | null = first; block; block = block.getNextBlock()) {
    const { x, y } = block.getRelativeToSurfaceXY()
    const ahead = view !== null && (y > view.bottom || x > view.right) && !kept.chain.has(block)
    hide(block.getSvgRoot(), ahead)
    if (ahead) return
    const left = view !== null && (y + block.height < view.top || x + block.width < view.left)
    const behind = left && !kept.shown.has(block)
    pass(block, behind)
    if (!behind) for (const row of rowsIn(block)) seeRow(row, view, kept)
  }
}

/** The first blocks of the rows inside of a block. */
const rowsIn = (block: Blockly.BlockSvg): readonly Blockly.BlockSvg[] =>
  block.statementInputCount === 0
    ? []
    : block.inputList.flatMap(({ connection, type }) => {
        const row = type === Blockly.inputs.inputTypes.STATEMENT ? connection?.targetBlock() : null
        return row instanceof Blockly.BlockSvg ? [row] : []
      })

const hide = (element: Element, on: boolean) =>
  element.classList.contains(hidden) !== on && element.classList.toggle(hidden, on)

/** Hides what is drawn of a block and what hangs in it, but not what follows it: that is drawn inside of it. */
function pass(block: Blockly.BlockSvg, on: boolean) {
  const before = passed.has(block)
  if (on && before) return
  if (on) passed.add(block)
  else passed.delete(block)
  // Rows inside are seen one by one; all else may have come hidden from where it was.
  const others = [block.getNextBlock(), ...(on || before ? [] : rowsIn(block))].map((one) =>
    one?.getSvgRoot(),
  )
  for (const element of block.getSvgRoot().children)
    if (!others.includes(element as SVGGElement)) hide(element, on)
}

/** What is not drawn cannot take the keyboard: it is drawn first. */
function showBeforeFocus(soon: () => void): () => void {
  const manager = Blockly.getFocusManager()
  const focus = manager.focusNode.bind(manager)
  manager.focusNode = (node) => {
    const { chain, shown } = keptFor(blockOf(node))
    for (const block of chain) hide(block.getSvgRoot(), false)
    for (const block of shown) pass(block, false)
    focus(node)
    soon()
  }
  return () => void (manager.focusNode = focus)
}
