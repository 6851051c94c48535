import {
  definitions,
  isBlockType,
  toolbox,
  type Category,
  type FieldLook,
  type InputLook,
  type Look,
  type Template,
  type ToolboxCategory,
} from '@botgarten/blocks'
import type * as Blockly from 'blockly/core'
import type { Words } from '#words/message.ts'
import { expertParts } from '../../model/packs.ts'
import { piecesOf } from '../../model/pieces.ts'

/** A block of the toolbox as it can be found. */
export interface Offer {
  readonly template: Template
  readonly category: Category
  /** What stands on the block. */
  readonly label: string
  /** What it is found by, the plainest words first; lower case, without marks on letters. */
  readonly found: readonly string[]
}

/** All that the toolbox offers now, in its order. */
export function offersOn(workspace: Blockly.WorkspaceSvg, all: boolean, words: Words): readonly Offer[] {
  const categories: readonly ToolboxCategory[] = (all && expertParts()?.everything(workspace)) || toolbox
  return categories.flatMap(({ category, blocks }) =>
    blocks.flatMap((template) => offerOf(template, category, words)),
  )
}

function offerOf(template: Template, category: Category, words: Words): readonly Offer[] {
  if (!isBlockType(template.type)) return []
  const definition = definitions[template.type]
  const help = words(definition.words.help)
  const written = labelOf(template, words)
  const label = /[^…\s]/.test(written) ? written : help
  const options = definition.look.fields.flatMap((look) =>
    look.kind === 'choice' ? look.options.map((option) => (option.words ? words(option.words) : '')) : [],
  )
  const family = words(`category.${category}`)
  const found = [label, [...options, family].join(' '), help]
  return [{ template, category, label, found: found.map(plain) }]
}

/** What stands on a block that lies on the toolbox; a gap is three dots. */
function labelOf(template: Template, words: Words): string {
  const { look } = definitions[template.type as keyof typeof definitions]
  const names = [...look.fields, ...look.inputs].map(({ name }) => name)
  const pieces = look.rows.flatMap((row) => piecesOf(row, [...names, 'ICON'], words))
  const texts = pieces.map((piece) =>
    'text' in piece ? piece.text : saidAt(piece.name, template, look, words),
  )
  const entries = look.items ? Object.values(template.values ?? {}).map(valueText) : []
  const called = look.args && template.mutation?.attrs?.['name']
  return [...texts, ...entries, called].filter(Boolean).join(' ')
}

function saidAt(name: string, template: Template, look: Look, words: Words): string {
  const field = look.fields.find((field) => field.name === name)
  if (field) return fieldText(field, template.fields?.[name], words)
  const input = look.inputs.find((input) => input.name === name)
  return input?.kind === 'value' && isThere(input, template) ? valueText(template.values?.[name]) : ''
}

const isThere = ({ when }: InputLook, { fields = {} }: Template): boolean =>
  !when || ('field' in when && when.is.includes(fields[when.field] ?? ''))

function fieldText(field: FieldLook, value: string | undefined, words: Words): string {
  if (field.kind === 'hidden') return ''
  const now = value ?? String(field.preset)
  if (field.kind !== 'choice') return now
  const option = field.options.find((option) => option.value === now)
  return option?.words ? words(option.words) : now
}

const valueText = (value: Template | undefined): string =>
  value?.fields?.['NUM'] ?? value?.fields?.['TEXT'] ?? '…'

const plain = (text: string): string => text.toLowerCase().normalize('NFD').replace(/\p{M}/gu, '')

/** Offers in which every word of the query begins a word, best first; what is inside of words comes after. */
export function matching(offers: readonly Offer[], query: string): readonly Offer[] {
  const asked = plain(query).split(/\s+/).filter(Boolean)
  if (asked.length === 0) return []
  return offers
    .map((offer) => ({ offer, rank: rankOf(offer, asked) }))
    .filter(({ rank }) => rank < Infinity)
    .sort((a, b) => a.rank - b.rank)
    .map(({ offer }) => offer)
}

function rankOf({ found }: Offer, asked: readonly string[]): number {
  const begins = found.findIndex((text) => asked.every((word) => ` ${text}`.includes(` ${word}`)))
  if (begins >= 0) return begins
  const holds = found.findIndex((text) => asked.every((word) => text.includes(word)))
  if (holds >= 0) return 3 + holds
  const whole = found.join(' ')
  return asked.every((word) => whole.includes(word)) ? 6 : Infinity
}
