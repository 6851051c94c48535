import * as Blockly from 'blockly/core'
import { layerGround } from './colours.ts'

/** Drawn 36 wide, 27 px at the start scale; the hand may miss by that much all round (44 px in all). */
const size = 36
const reach = 58

const strokes = { plus: 'M11 18h14M18 11v14', minus: 'M11 18h14' }

/** A round button on a block: mouse, touch, and Enter when the keyboard stands on it. */
export class ButtonField extends Blockly.FieldImage {
  readonly #kind: keyof typeof strokes

  constructor(kind: keyof typeof strokes, label: string, onpress: () => void) {
    super(picture(kind), size, size, label, onpress)
    this.#kind = kind
  }

  override initView() {
    super.initView()
    const middle = { cx: size / 2, cy: size / 2, r: size / 2 + 2 }
    Blockly.utils.dom.createSvgElement(
      'circle',
      { ...middle, class: 'blocklyFocusRing', fill: 'none' },
      this.fieldGroup_,
    )
    const target = {
      x: (size - reach) / 2,
      y: (size - reach) / 2,
      width: reach,
      height: reach,
      rx: reach / 2,
    }
    Blockly.utils.dom.createSvgElement('rect', { ...target, fill: 'transparent' }, this.fieldGroup_)
    this.fieldGroup_?.classList.add('editor-button', `editor-${this.#kind}`)
  }
}

function picture(kind: keyof typeof strokes): string {
  const disc = `<circle cx="18" cy="18" r="17.5" fill="#fff" stroke="#631832"/>`
  const sign = `<path d="${strokes[kind]}" stroke="${layerGround}" stroke-width="3" stroke-linecap="round"/>`
  return `data:image/svg+xml,${encodeURIComponent(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 36 36">${disc}${sign}</svg>`)}`
}
