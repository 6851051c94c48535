import * as Blockly from 'blockly/core'
import { optionFor } from '@botgarten/blocks'
import type { Definition, FieldLook, InputLook, Look, NeuronLook } from '@botgarten/blocks'
import { applyFace, faceField, type BotBlock, type Extra } from '../model/bot-block.ts'
import { ChoiceField } from './choice-field.ts'
import { apricot, teal } from './colours.ts'
import { DotField, HiddenField, NumberField, TextField } from './fields.ts'
import { iconField } from './icons.ts'
import { buildList, matchLines } from '../model/list.ts'
import { piecesOf } from '../model/pieces.ts'
import { decimalMark } from '#drawing/numbers.ts'
import type { Locale } from '#words/language.svelte.ts'
import { hasMessage, type Words } from '#words/message.ts'

export interface Language {
  readonly words: Words
  readonly locale: Locale
}

const dotName = 'BOTGARTEN_DOT'

/** Parts of blocks that come and go with their state. The expert pack brings them. */
export interface ComingParts {
  build(block: BotBlock, language: Language): void
  match(block: BotBlock, language: Language): void
  nameField(look: FieldLook & { readonly kind: 'name' }, block: BotBlock): Blockly.Field
}
let coming: ComingParts | null = null
export const knowComingParts = (parts: ComingParts): void => void (coming = parts)

/** Where a part comes that is not there yet. */
export const anchorOf = (name: string): string => `${name}_ANCHOR`

/** Makes a Blockly block of every definition. Called again when the language changes. */
export function defineBlocks(definitions: Iterable<Definition>, language: Language): void {
  for (const definition of definitions) Blockly.Blocks[definition.type] = behaviour(definition, language)
}

function behaviour(definition: Definition, language: Language) {
  return {
    init(this: BotBlock) {
      this.definition = definition
      this.extra = {}
      this.frame = null
      this.copyOf = null
      build(this, language)
    },
    getAriaLabel(this: Blockly.BlockSvg, verbosity: Blockly.utils.aria.Verbosity) {
      const label = Blockly.BlockSvg.prototype.getAriaLabel.call(this, verbosity)
      return label.split(', ').filter(Boolean).join(', ')
    },
    saveExtraState(this: BotBlock): Extra | null {
      const name = faceField(definition.look)
      const face = name === undefined ? undefined : (this.getFieldValue(name) as string)
      const self = definition.neuron || definition.look.layer ? { self: this.id } : {}
      const extra = { ...this.extra, ...self, ...(face === undefined ? {} : { face }) }
      return Object.keys(extra).length > 0 ? extra : null
    },
    loadExtraState(this: BotBlock, { face, self, ...extra }: Extra) {
      this.extra = extra
      this.copyOf = self === undefined || self === this.id ? this.copyOf : self
      const name = faceField(definition.look)
      if (name !== undefined && face !== undefined) this.getField(name)?.setValue(face, false)
      applyFace(this)
      matchLines(this, language.words)
      coming?.match(this, language)
    },
  }
}

function build(block: BotBlock, language: Language) {
  const { look, words } = block.definition
  block.setStyle(look.category)
  block.setTooltip(() => (hasMessage(words.help) ? language.words(words.help) : '…'))
  block.setInputsInline(true)
  connect(block, look)
  look.rows.forEach((key, at) => new RowBuilder(block, language, at === 0).build(key))
  addHiddenFields(block, look)
  if (look.items) buildList(block, language.words)
  applyFace(block)
  coming?.build(block, language)
}

function connect(block: BotBlock, look: Look) {
  if (look.shape === 'value') return
  if (look.shape === 'hat' || look.shape === 'function') block.hat = 'cap'
  else block.setPreviousStatement(true)
  if (look.shape !== 'function') block.setNextStatement(true)
}

function addHiddenFields(block: BotBlock, look: Look) {
  const hidden = look.fields.filter((field) => field.kind === 'hidden')
  if (hidden.length === 0) return
  const input = block.appendDummyInput()
  for (const field of hidden) input.appendField(new HiddenField(field.preset), field.name)
  input.setVisible(false)
}

/** Builds one row of a block from its words. */
class RowBuilder {
  readonly #block: BotBlock
  readonly #language: Language
  #waiting: [Blockly.Field, string?][] = []
  #openRow = false

  constructor(block: BotBlock, language: Language, first: boolean) {
    this.#block = block
    this.#language = language
    const { neuron } = block.definition
    if (first && neuron) this.#waiting.push([new DotField(neuronColour(neuron, block)), dotName])
  }

  build(key: string) {
    const { look } = this.#block.definition
    const names = [...look.fields.map(({ name }) => name), ...look.inputs.map(({ name }) => name), 'ICON']
    for (const piece of piecesOf(key, names, this.#language.words)) {
      if ('text' in piece) this.#waiting.push([new Blockly.FieldLabel(piece.text)])
      else this.#place(piece.name, look)
    }
    this.#close(look)
  }

  #place(name: string, look: Look) {
    const field = look.fields.find((field) => field.name === name)
    const input = look.inputs.find((input) => input.name === name)
    if (field) this.#waiting.push([makeField(field, this.#block, this.#language), name])
    else if (input) {
      if (!input.when) this.#placeInput(input)
      else if (coming) this.#anchor(input.name)
    } else if (look.icon) this.#waiting.push([iconField(look.icon)])
  }

  #placeInput(input: InputLook) {
    if (input.kind === 'value') {
      this.#flush(
        this.#block
          .appendValueInput(input.name)
          .setCheck(input.accepts.length > 0 ? [...input.accepts] : null),
      )
      this.#openRow = true
      return
    }
    if (this.#waiting.length > 0) this.#flush(this.#block.appendEndRowInput())
    this.#block.appendStatementInput(input.name)
    this.#openRow = false
  }

  #anchor(name: string) {
    this.#flush(this.#block.appendDummyInput(anchorOf(name)))
    this.#openRow = true
  }

  #close(look: Look) {
    if (this.#waiting.length === 0 && !this.#openRow) return
    // The arrow of a loop stands alone in its last row, at the right.
    const arrow = look.icon === 'repeat' && this.#waiting.length === 1 && !this.#openRow
    const atRight = arrow && this.#waiting[0]?.[0] instanceof Blockly.FieldImage
    const input = this.#block.appendEndRowInput()
    if (atRight) input.setAlign(Blockly.inputs.Align.RIGHT)
    this.#flush(input)
  }

  #flush(input: Blockly.Input) {
    for (const [field, name] of this.#waiting) input.appendField(field, name)
    this.#waiting = []
  }
}

function makeField(look: FieldLook, block: BotBlock, language: Language): Blockly.Field {
  const { words, locale } = language
  switch (look.kind) {
    case 'number':
      return new NumberField(look, decimalMark(locale))
    case 'name':
      return coming?.nameField(look, block) ?? new TextField(look.preset)
    case 'text':
      return new TextField(look.preset)
    case 'hidden':
      return new HiddenField(look.preset)
    case 'choice': {
      const options = look.options.map(({ value, words: key, dot, label }) => ({
        value,
        label: key === null ? (label ?? value) : words(key),
        ...(dot === undefined ? {} : { dot }),
      }))
      const almost = (name: string) => words('choice.almost', { name })
      return new ChoiceField(options, look.preset, () => choiceChanged(block, look.name, language), almost)
    }
  }
}

/** A choice may tell the block's face or the colour of its dot. */
function choiceChanged(block: BotBlock, name: string, language: Language) {
  const { look, neuron } = block.definition
  if (faceField(look) === name && block.outputConnection) applyFace(block)
  coming?.match(block, language)
  if (neuron) block.getField(dotName)?.setValue(neuronColour(neuron, block), false)
}

function neuronColour(neuron: NeuronLook, block: BotBlock): string {
  if (neuron.colour === 'sensor') return teal
  if (neuron.colour === 'actuator') return apricot
  const { field: name } = neuron.colour
  const look = block.definition.look.fields.find((field) => field.name === name)
  const value = (block.getFieldValue(name) as string | null) ?? look?.preset
  const option = look?.kind === 'choice' ? optionFor(look.options, String(value)) : undefined
  return option?.dot ?? String(value)
}
