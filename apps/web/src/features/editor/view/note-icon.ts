import * as Blockly from 'blockly/core'
import { ink } from './colours.ts'

const { CommentIcon, registry } = Blockly.icons
const side = 26

/** The sheet at a block that has a note. */
class NoteIcon extends CommentIcon {
  override initView(onpointerdown: (event: PointerEvent) => void) {
    if (this.svgRoot) return
    super.initView(onpointerdown)
    const root = this.getFocusableElement()
    root.replaceChildren()
    const draw = (attributes: Record<string, string | number>) =>
      Blockly.utils.dom.createSvgElement('path', attributes, root)
    draw({ d: 'M3 2H17L23 8V24H3Z', fill: '#fff6dd', stroke: ink, 'stroke-width': 2 })
    draw({ d: 'M8 12H18M8 17H15', stroke: ink, 'stroke-width': 2.4, 'stroke-linecap': 'round' })
    draw({ d: 'M-8 -14H34V40H-8Z', fill: 'transparent' })
  }

  /** A note that nobody writes in closes: it lies over other blocks. */
  override async setBubbleVisible(visible: boolean) {
    await super.setBubbleVisible(visible)
    const bubble = this.getBubble()
    const outside = (to: EventTarget | null) =>
      !(to instanceof Node && bubble?.getFocusableElement().contains(to))
    const leave = ({ relatedTarget }: FocusEvent) =>
      outside(relatedTarget) && void this.setBubbleVisible(false)
    bubble?.getFocusableElement().addEventListener('focusout', leave as EventListener)
  }

  override getSize() {
    return new Blockly.utils.Size(side, side)
  }
}

export function registerNotes(): void {
  registry.unregister(CommentIcon.TYPE.toString())
  registry.register(CommentIcon.TYPE, NoteIcon)
}

/** Gives the block a note and lets the child write, or takes its note away. */
export async function toggleNote(block: Blockly.BlockSvg): Promise<void> {
  block.setCommentText(block.getIcon(CommentIcon.TYPE) ? null : '')
  const note = block.getIcon(CommentIcon.TYPE)
  await note?.setBubbleVisible(true)
  const editor = (note as NoteIcon | undefined)?.getBubble()?.getEditor()
  if (editor) Blockly.getFocusManager().focusNode(editor)
}
