import * as Blockly from 'blockly/core'
import { nearestOption, optionFor } from '@botgarten/blocks'
import { drawDot, type FileField } from './fields.ts'

export interface Option {
  readonly value: string
  readonly label: string
  /** `#RRGGBB` */
  readonly dot?: string
}

const dotSpace = 24

/** A drop-down. Colours carry a ringed dot; a value that only a file knows is shown as it is, never changed. */
export class ChoiceField extends Blockly.FieldDropdown implements FileField {
  readonly #options: readonly Option[]
  readonly #onchange: (value: string) => void
  /** Words for a colour that comes near to one of the options. */
  readonly #almost: (label: string) => string
  #dot: SVGElement | null = null

  constructor(
    options: readonly Option[],
    preset: string,
    onchange: (value: string) => void = () => {},
    almost = (label: string) => label,
  ) {
    super(Blockly.Field.SKIP_SETUP)
    this.#options = options
    this.#onchange = onchange
    this.#almost = almost
    this.setOptions(options.map(menuOption))
    this.setValue(preset)
  }

  toFile(): string {
    return this.getValue() ?? ''
  }

  override initView() {
    super.initView()
    this.#dot = drawDot(this.fieldGroup_, '#000')
  }

  /** Blockly would cut the words that all options share and write them before the drop-down. */
  protected override trimOptions(options: Blockly.MenuOption[]) {
    return { options }
  }

  protected override doClassValidation_(value?: unknown) {
    if (typeof value !== 'string') return null
    const menu = this.getOptions(true)
    if (!menu.some((option) => option[1] === value)) menu.push(menuOption({ ...this.#like(value), value }))
    return value
  }

  protected override doValueUpdate_(value: string) {
    super.doValueUpdate_(value)
    // The constructor of the base class calls this too, before our own fields are there.
    if (#onchange in this) this.#onchange(value)
  }

  protected override render_() {
    super.render_()
    const colour = this.#like(this.getValue() ?? '').dot
    this.#dot?.setAttribute('display', colour ? 'inline' : 'none')
    if (colour) this.#makeRoomForDot(colour)
  }

  protected override showEditor_(event?: MouseEvent) {
    super.showEditor_(event)
    // Blockly leaves its list of choices without a name.
    const menu = Blockly.DropDownDiv.getContentDiv().querySelector('[role=listbox]')
    menu?.setAttribute('aria-label', this.getAriaTypeName() ?? '')
  }

  override applyColour() {
    super.applyColour()
    const block = this.getSourceBlock()
    if (!(block instanceof Blockly.BlockSvg)) return
    this.borderRect_?.setAttribute(
      'fill',
      this.menu_ ? block.getColourTertiary() : block.getColourSecondary(),
    )
  }

  #like(value: string): Omit<Option, 'value'> {
    const near = nearestOption(this.#options, value)
    return (
      optionFor(this.#options, value) ??
      (near ? { label: this.#almost(near.label), dot: value } : { label: value })
    )
  }

  #makeRoomForDot(colour: string) {
    const padding = this.getConstants()?.FIELD_BORDER_RECT_X_PADDING ?? 0
    const { width, height } = this.size_
    this.size_ = new Blockly.utils.Size(width + dotSpace, height)
    this.positionBorderRect_()
    this.textElement_?.setAttribute('x', String(padding + dotSpace))
    this.fieldGroup_?.querySelectorAll('image')[1]?.setAttribute('x', String(dotSpace))
    this.#dot?.setAttribute('fill', colour)
    this.#dot?.setAttribute('transform', `translate(${padding + 8} ${height / 2})`)
  }
}

function menuOption({ value, label, dot }: Option): Blockly.MenuOption {
  return dot && typeof document !== 'undefined' ? [dotted(label, dot), value, label] : [label, value]
}

function dotted(label: string, colour: string): HTMLElement {
  const element = document.createElement('span')
  element.className = 'editor-dotted'
  element.style.setProperty('--dot', colour)
  element.setAttribute('aria-label', label)
  element.textContent = label
  return element
}
