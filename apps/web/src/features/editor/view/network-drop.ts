import * as Blockly from 'blockly/core'
import type { NetworkDrop } from '#lab/blocks.ts'
import { holdsNetwork, networkIn } from '../model/put-in.ts'

class DropTarget extends Blockly.DragTarget {
  override id = 'networkPane'
  readonly #drop: NetworkDrop
  readonly #dropped: (block: string) => void
  isOver = false

  constructor(drop: NetworkDrop, dropped: (block: string) => void) {
    super()
    this.#drop = drop
    this.#dropped = dropped
  }

  override getClientRect() {
    const { top, bottom, left, right } = this.#drop.place()?.getBoundingClientRect() ?? new DOMRect()
    return right > left ? new Blockly.utils.Rect(top, bottom, left, right) : null
  }

  override onDragEnter(held: Blockly.IDraggable) {
    this.isOver = true
    if (isNetwork(held)) this.#drop.hover('over')
  }

  override onDragExit(held: Blockly.IDraggable) {
    this.isOver = false
    if (isNetwork(held)) this.#drop.hover('away')
  }

  override onDrop(held: Blockly.IDraggable) {
    this.isOver = false
    this.#drop.hover(null)
    if (isNetwork(held)) this.#dropped(held.id)
  }
}

const isNetwork = (held: Blockly.IDraggable): held is Blockly.BlockSvg =>
  held instanceof Blockly.BlockSvg && holdsNetwork(held)

/** `dropped` is called with the network when Blockly has let the block go, in the same step of undo. Returns how to measure the place again. */
export function takeNetworks(
  workspace: Blockly.WorkspaceSvg,
  drop: NetworkDrop,
  dropped: (network: string) => void,
): () => void {
  const component = new DropTarget(drop, (block) => {
    const group = Blockly.Events.getGroup()
    queueMicrotask(() => {
      Blockly.Events.setGroup(group || true)
      const held = workspace.getBlockById(block)
      const network = held && networkIn(held)
      if (network) dropped(network.id)
      Blockly.Events.setGroup(false)
    })
  })
  const capabilities = [Blockly.ComponentManager.Capability.DRAG_TARGET]
  workspace.getComponentManager().addComponent({ component, weight: 2, capabilities })
  workspace.addChangeListener((event) => {
    if (!(event instanceof Blockly.Events.BlockDrag)) return
    const held = workspace.getBlockById(event.blockId ?? '')
    if (!event.isStart) drop.hover(null)
    // Blockly tells of the beginning a little later: the hand may be there already.
    else if (held && holdsNetwork(held) && !component.isOver) drop.hover('away')
  })
  return () => workspace.recordDragTargets()
}
