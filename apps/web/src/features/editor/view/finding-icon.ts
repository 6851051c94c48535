import * as Blockly from 'blockly/core'
import type { Finding } from '@botgarten/blocks'
import { ink } from './colours.ts'

const iconType = new Blockly.icons.IconType<FindingIcon>('botgarten_finding')
const radius = 13
/** The badge is drawn 20 px wide at the start scale; 44 px of it answer to a finger. */
const reach = 29

/** The yellow badge at the corner of a block that needs help. A button for the mouse, the finger and the keyboard. */
export class FindingIcon extends Blockly.icons.Icon {
  #finding: Finding
  readonly #label: string
  readonly #open: (finding: Finding) => void

  constructor(block: Blockly.BlockSvg, finding: Finding, label: string, open: (finding: Finding) => void) {
    super(block)
    this.#finding = finding
    this.#label = label
    this.#open = open
    this.setTooltip(label)
  }

  override getType() {
    return iconType
  }

  override initView(onpointerdown: (event: PointerEvent) => void) {
    if (this.svgRoot) return
    super.initView(onpointerdown)
    this.getFocusableElement().classList.add('editor-badge')
    const draw = (name: string, attributes: Record<string, string | number>) =>
      Blockly.utils.dom.createSvgElement(name, attributes, this.svgRoot)
    const robot = this.#finding.mark === 'robot'
    const sign = robot ? '#fff' : ink
    draw('circle', { class: `blocklyIconShape${robot ? ' robot' : ''}`, r: radius })
    // A plug that is pulled out; or “!”.
    const d = robot ? 'M-3 -7v4M3 -7v4M-5.5 -3h11v2a5.5 5.5 0 0 1-11 0zM0 5v3' : 'M0 -6.5v7M0 6v.1'
    const width = robot ? 2 : 3.4
    draw('path', { d, fill: 'none', stroke: sign, 'stroke-width': width, 'stroke-linecap': 'round' })
    draw('circle', { r: reach, fill: 'transparent' })
  }

  /** Does it say this already? Then it opens the new finding; a badge that stays keeps the keyboard's place. */
  says(label: string, finding: Finding): boolean {
    if (label === this.#label) this.#finding = finding
    return label === this.#label
  }

  override getSize() {
    return new Blockly.utils.Size(0, 0)
  }

  override onClick() {
    this.#open(this.#finding)
  }

  protected override getAriaLabel() {
    return this.#label
  }

  override isShownWhenCollapsed() {
    return true
  }
}

/** The badge sits on the block's upper right corner. Called whenever the block was drawn. */
export function placeBadge(block: Blockly.BlockSvg): void {
  const badge = block.getIcon(iconType)
  badge?.setOffsetInBlock(new Blockly.utils.Coordinate(block.childlessWidth - 2, 2))
}

/** Puts a badge on every block that a finding names and takes the others away. */
export function showFindings(
  workspace: Blockly.WorkspaceSvg,
  findings: readonly Finding[],
  label: (finding: Finding) => string,
  open: (finding: Finding) => void,
): void {
  const byBlock = new Map(findings.map((finding) => [finding.block, finding]))
  for (const block of workspace.getAllBlocks(false)) {
    const finding = byBlock.get(block.id)
    const badge = block.getIcon(iconType)
    if (finding && badge?.says(label(finding), finding)) continue
    if (badge) block.removeIcon(iconType)
    block.getSvgRoot().classList.toggle('editor-finding', finding !== undefined)
    if (finding) block.addIcon(new FindingIcon(block, finding, label(finding), open))
  }
}
