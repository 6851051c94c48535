import * as Blockly from 'blockly/core'
import { teal } from './colours.ts'

/** What a file said, kept as long as nobody changes the field: "0.10" and "1e2" travel as they came. */
interface Told {
  readonly text: string
  readonly value: unknown
}

/** A field whose text in the file may differ from its value on the screen. */
export interface FileField extends Blockly.Field {
  toFile(): string
}

export const isFileField = (field: Blockly.Field): field is FileField => 'toFile' in field

/**
 * What a hand may hit around a field's text: at least as high as its pill, 24 px at the start scale; the style sheet adds
 * what a finger needs. On a block that is nothing but its field only the text would be there, 16 px high.
 */
class Reach {
  readonly #rect: SVGElement

  constructor(group: SVGElement) {
    this.#rect = Blockly.utils.dom.createSvgElement('rect', { class: 'editor-reach', fill: 'transparent' })
    group.prepend(this.#rect)
  }

  fit({ width, height }: Blockly.utils.Size) {
    const wide = Math.max(width, reach)
    const high = Math.max(height, reach)
    const place = { x: (width - wide) / 2, y: (height - high) / 2, width: wide, height: high }
    for (const [name, value] of Object.entries(place)) this.#rect.setAttribute(name, String(value))
  }
}

/** 24 px where blocks start, at a scale of 0.76. */
const reach = 32

/** A number in a white pill. Takes both decimal signs and shows the one of the language. */
export class NumberField extends Blockly.FieldNumber implements FileField {
  #told: Told | null = null
  #reach: Reach | null = null
  readonly #decimal: string

  constructor(look: { preset: number; min?: number; max?: number; step?: number }, decimal: string) {
    super(look.preset, look.min, look.max, look.step)
    this.#decimal = decimal
  }

  override initView() {
    super.initView()
    if (this.fieldGroup_) this.#reach = new Reach(this.fieldGroup_)
  }

  protected override updateSize_(margin?: number) {
    super.updateSize_(margin)
    this.#reach?.fit(this.size_)
  }

  /** A number that a file brought is shown even where it lies outside of what a hand may set. */
  override loadState(state: unknown) {
    const text = String(state)
    const number = Number(text)
    if (text.trim() !== '' && Number.isFinite(number)) this.#admit(number)
    this.#told = { text, value: this.getValue() }
  }

  override saveState() {
    return this.toFile()
  }

  toFile(): string {
    return this.#told?.value === this.getValue() ? this.#told.text : String(this.getValue())
  }

  #admit(number: number) {
    if (number < this.getMin()) this.setMin(number)
    if (number > this.getMax()) this.setMax(number)
    this.setValue(number)
    if (this.getValue() === number) return
    this.setPrecision(0)
    this.setValue(number)
  }

  protected override doClassValidation_(value?: unknown) {
    return super.doClassValidation_(typeof value === 'string' ? value.replace(',', '.') : value)
  }

  protected override getText_() {
    return super.getText_() ?? this.getEditorText_(this.getValue())
  }

  protected override getEditorText_(value: unknown) {
    return String(value).replace('.', this.#decimal).replace('-', '−')
  }

  protected override getValueFromEditorText_(text: string) {
    return text.replace('−', '-')
  }

  protected override widgetCreate_() {
    const input = super.widgetCreate_()
    input.inputMode = this.getMin() < 0 ? 'text' : 'decimal'
    return input
  }
}

/** Free text in a white pill. */
export class TextField extends Blockly.FieldTextInput implements FileField {
  #reach: Reach | null = null

  constructor(preset: string) {
    super(preset, undefined, { spellcheck: false })
  }

  override initView() {
    super.initView()
    if (this.fieldGroup_) this.#reach = new Reach(this.fieldGroup_)
  }

  protected override updateSize_(margin?: number) {
    super.updateSize_(margin)
    this.#reach?.fit(this.size_)
  }

  /** An empty field is wide enough to be hit. */
  protected override getDisplayText_() {
    const text = super.getDisplayText_()
    return text.trim() ? text : '\u00A0'.repeat(4)
  }

  toFile(): string {
    return this.getValue() ?? ''
  }
}

/** In the file, never on the block. */
export class HiddenField extends Blockly.FieldLabelSerializable implements FileField {
  constructor(preset: string) {
    super(preset)
    this.setVisible(false)
  }

  override computeAriaLabel() {
    return ''
  }

  toFile(): string {
    return this.getValue() ?? ''
  }
}

const dotRadius = 8

/** A neuron's mark: a dot in the colour it has in the playground, ringed in white. */
export class DotField extends Blockly.Field<string> {
  #circle: SVGElement | null = null
  override EDITABLE = false

  constructor(colour = teal) {
    super(colour)
    this.size_ = new Blockly.utils.Size(2 * dotRadius + 2, 2 * dotRadius + 2)
  }

  override initView() {
    this.#circle = drawDot(this.fieldGroup_, this.getValue() ?? teal)
    this.#circle.setAttribute('transform', `translate(${dotRadius + 1} ${dotRadius + 1})`)
    this.fieldGroup_?.setAttribute('aria-hidden', 'true')
  }

  protected override render_() {
    this.#circle?.setAttribute('fill', this.getValue() ?? teal)
  }

  protected override updateSize_() {}

  override computeAriaLabel() {
    return ''
  }
}

export function drawDot(parent: Element | null, colour: string): SVGElement {
  return Blockly.utils.dom.createSvgElement(
    'circle',
    { r: dotRadius - 1, fill: colour, stroke: '#fff', 'stroke-width': 2 },
    parent,
  )
}
