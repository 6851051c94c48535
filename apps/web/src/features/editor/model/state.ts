import type * as Blockly from 'blockly/core'
import {
  definitions,
  isBlockType,
  rowCount,
  rowName,
  type Block,
  type Definition,
  type Template,
} from '@botgarten/blocks'
import { holesOf, shapeOf as shapeNow, statementNames } from '@botgarten/programs'
import type { Extra, Rest } from './bot-block.ts'
import { faceField } from './bot-block.ts'
import { fits, isWholeShadow } from './fits.ts'

export type State = Blockly.serialization.blocks.State
type ConnectionState = Blockly.serialization.blocks.ConnectionState
type Source = Template & { readonly id?: string }

/** Blocks that do not fit where the file has them: they lie beside their stack, so that nothing is lost. */
export type Loose = (readonly Block[])[]

export const unknownTypes = { value: 'botgarten_unknown_value', statement: 'botgarten_unknown' } as const

const definitionOf = (type: string): Definition | undefined =>
  isBlockType(type) ? definitions[type] : undefined

/** A row of blocks, each hanging on the one before. Undefined where none of them can hang there. */
export function stateOfRow(blocks: readonly Source[], loose: Loose, first: boolean): State | undefined {
  const cut = blocks.findIndex((block, at) => (at > 0 || !first) && shapeOf(block) === 'hat')
  if (cut >= 0) loose.push(blocks.slice(cut) as Block[])
  const row = cut < 0 ? blocks : blocks.slice(0, cut)
  const alone = first && row[0] && shapeOf(row[0]) === 'value'
  if (alone && row.length > 1) loose.push(row.slice(1) as Block[])
  const hanging = alone ? row.slice(0, 1) : row.filter((block) => hangs(block, loose))
  return hanging.reduceRight<State | undefined>(
    (next, block) => ({
      ...stateOfBlock(block, loose, alone ? 'value' : 'statement'),
      ...(next && { next: { block: next } }),
    }),
    undefined,
  )
}

function shapeOf(block: Source): 'hat' | 'statement' | 'value' {
  const definition = definitionOf(block.type)
  const shape = definition ? shapeNow(asBlock(block), definition.look) : 'statement'
  return shape === 'function' ? 'hat' : shape
}

function hangs(block: Source, loose: Loose): boolean {
  const does = shapeOf(block) !== 'value'
  if (!does) loose.push([block as Block])
  return does
}

export const stateOfTemplate = (template: Template): State =>
  stateOfBlock(template, [], shapeOf(template) === 'value' ? 'value' : 'statement')

function stateOfBlock(block: Source, loose: Loose, place: 'value' | 'statement'): State {
  const definition = definitionOf(block.type)
  const identity = block.id === undefined ? {} : { id: block.id }
  if (!definition) return { type: unknownTypes[place], ...identity, extraState: { block } }
  return {
    type: block.type,
    ...identity,
    ...(block.collapsed && { collapsed: true }),
    ...(block.disabled && { disabledReasons: ['MANUALLY_DISABLED'] }),
    ...(block.comment && { icons: { comment: { text: block.comment } } }),
    fields: shownFields(block, definition),
    inputs: { ...valueStates(block, definition, loose), ...statementStates(block, definition, loose) },
    extraState: extraOf(block, definition),
  }
}

const shownFields = (block: Source, { look }: Definition) =>
  pick(block.fields, (name) => look.fields.some((field) => field.name === name))

/** Names and accepted types of the value inputs that the block has, lines of a growing list included. */
function sockets(block: Source, definition: Definition): ReadonlyMap<string, Accepts> {
  return new Map(holesOf(asBlock(block), definition).map(({ input, accepts }) => [input, accepts]))
}

type Accepts = ReturnType<typeof holesOf>[number]['accepts']
const asBlock = (block: Source): Block => ({ id: '', ...block }) as Block

const linesIn = (block: Source, look: Definition['look']) =>
  look.items ? Array.from({ length: rowCount(asBlock(block)) }, (_, k) => rowName(k)) : []

function valueStates(block: Source, definition: Definition, loose: Loose) {
  const states: Record<string, ConnectionState> = {}
  for (const [name, accepts] of sockets(block, definition)) {
    const child = block.values?.[name]
    if (child === undefined) continue
    if (!fits(child, accepts)) loose.push([child as Block])
    else if (isWholeShadow(child)) states[name] = { shadow: stateOfBlock(child, loose, 'value') }
    else states[name] = { block: stateOfBlock(child, loose, 'value') }
  }
  return states
}

function statementStates(block: Source, { look }: Definition, loose: Loose) {
  const states: Record<string, ConnectionState> = {}
  for (const name of statementNames(asBlock(block), look)) {
    const row = stateOfRow(block.statements?.[name] ?? [], loose, false)
    if (row) states[name] = { block: row }
  }
  return states
}

function extraOf(block: Source, definition: Definition): Extra {
  const { look } = definition
  const { items: _items, ...attributes } = block.mutation?.attrs ?? {}
  const faceName = faceField(look)
  const face = faceName === undefined ? undefined : block.fields?.[faceName]
  const lines = linesIn(block, look)
  return {
    attributes: look.items ? attributes : (block.mutation?.attrs ?? {}),
    ...(look.items && { lines }),
    ...(face !== undefined && { face }),
    rest: restOf(block, definition),
  }
}

/** What the look does not show. `told` only where the block comes from a file. */
function restOf(block: Source, definition: Definition): Rest {
  const { look } = definition
  const inputs = sockets(block, definition)
  const fields = pick(block.fields, (name) => !look.fields.some((field) => field.name === name))
  const values = pick(block.values, (name) => !inputs.has(name))
  const rows = statementNames(asBlock(block), look)
  const statements = pick(block.statements, (name) => !rows.includes(name))
  return {
    ...pick(block as Record<string, unknown>, (name) => ['data', 'hide', 'inline', 'flags'].includes(name)),
    ...(block.mutation?.args && { args: block.mutation.args }),
    ...(block.shadow && !isWholeShadow(block) && { shadow: true }),
    ...(Object.keys(fields).length > 0 && { fields }),
    ...(Object.keys(values).length > 0 && { values: values as Block['values'] }),
    ...(Object.keys(statements).length > 0 && { statements: statements as Block['statements'] }),
    ...(block.id !== undefined && { told: toldBy(block, look) }),
  }
}

function toldBy(block: Source, look: Definition['look']): Rest['told'] {
  const attributes = block.mutation ? Object.keys(block.mutation.attrs) : null
  const names = Object.values(look.mutation ?? {}).flatMap((said) =>
    typeof said === 'string' ? [] : [said.field],
  )
  const repeated = pick(block.fields, (name) => names.includes(name))
  const differs = Object.entries(look.mutation ?? {}).some(
    ([name, said]) =>
      typeof said === 'object' &&
      !('is' in said) &&
      block.mutation?.attrs[name] !== block.fields?.[said.field],
  )
  return { fields: Object.keys(block.fields ?? {}), attributes, ...(differs && { repeated }) }
}

function pick<Value>(
  record: { readonly [name: string]: Value } | undefined,
  keep: (name: string) => boolean,
) {
  return Object.fromEntries(Object.entries(record ?? {}).filter(([name]) => keep(name)))
}
