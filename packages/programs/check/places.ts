import {
  definitions,
  entryOf,
  isBlockType,
  isKind,
  listOf,
  plugged,
  rowCount,
  rowName,
} from '@botgarten/blocks'
import type { Block, Definition, Face, InputLook, Look, Typed, ValueType } from '@botgarten/blocks'
import { holds } from '../run/shape-of.ts'

export const definitionOf = ({ type }: Block): Definition | null =>
  isBlockType(type) ? definitions[type] : null

/** The first face where a file names another. */
function faceOf(block: Block, look: Look): Face | undefined {
  return look.faces && (namedFace(block, look) ?? Object.values(look.faces.of)[0])
}

function namedFace(block: Block, { faces, fields }: Look): Face | undefined {
  if (!faces) return undefined
  const { by } = faces
  if ('attribute' in by) return own(faces.of, block.mutation?.attrs[by.attribute])
  const look = fields.find(({ name }) => name === by.field)
  return own(faces.of, block.fields?.[by.field] ?? String(look?.preset))
}

const own = <T>(record: { readonly [name: string]: T }, name: string | undefined): T | undefined =>
  name !== undefined && Object.hasOwn(record, name) ? record[name] : undefined

/** What a block gives; 'any' where only the run can tell. */
export type Output = ValueType | 'any'

/** The type a block was given, or takes from what is plugged into it; null where that is not known. */
function ownType(block: Block, { by, preset }: Typed): ValueType | null {
  if ('input' in by) {
    const child = plugged(block, by.input)
    const output = child && outputIn(child)
    if (output === undefined || output === 'any') return null
    return by.entry ? entryOf(output) : output
  }
  const said = 'field' in by ? block.fields?.[by.field] : block.mutation?.attrs[by.attribute]
  if (said === undefined) return 'field' in by ? preset : null
  return isKind(said) ? said : null
}

function outputIn(block: Block): Output | undefined {
  const definition = definitionOf(block)
  return definition ? outputOf(block, definition) : undefined
}

/** The kind of value a block gives; undefined for blocks that give none. */
export function outputOf(block: Block, { look }: Definition): Output | undefined {
  const { typed } = look
  if (!typed?.output) return faceOf(block, look)?.output ?? look.output
  const type = ownType(block, typed)
  if (type === null) return 'any'
  return typed.output === 'list' ? listOf(type) : type
}

/** A hole for a value: what stands in it, and what may; 'any' where only the run can tell. */
export interface Hole {
  readonly input: string
  readonly child: Block | undefined
  readonly accepts: readonly ValueType[] | 'any'
  readonly optional: boolean
  /** A block that names a variable stands here. */
  readonly target: boolean
}

type Place = Omit<Hole, 'child'>

function acceptedBy(
  block: Block,
  { typed }: Look,
  name: string,
  accepts: readonly ValueType[],
): Place['accepts'] {
  const how = typed?.inputs?.[name]
  if (!typed || !how) return accepts
  const type = ownType(block, typed)
  if (type === null) return 'any'
  return [how === 'list' ? listOf(type) : type]
}

const isThere = (block: Block, look: Look, input: InputLook) => !input.when || holds(block, input.when, look)

function namedPlaces(block: Block, look: Look): Place[] {
  return look.inputs.flatMap((input) => {
    if (input.kind !== 'value' || !isThere(block, look, input)) return []
    const { name, optional = false, target = false } = input
    return [{ input: name, accepts: acceptedBy(block, look, name, input.accepts), optional, target }]
  })
}

const place = (input: string, accepts: Place['accepts'], optional = false): Place => ({
  input,
  accepts,
  optional,
  target: false,
})

function rowPlaces(block: Block, look: Look): Place[] {
  const { items, typed } = look
  if (!items) return []
  const type = typed?.items && ownType(block, typed)
  const accepts = faceOf(block, look)?.items?.accepts ?? (type ? [type] : (items.accepts ?? 'any'))
  return Array.from({ length: rowCount(block) }, (_, k) => place(rowName(k), accepts, true))
}

/** How many ways a decision or a wait has besides its first. */
const waysOf = (block: Block, { branches }: Look): number =>
  branches ? Math.min(Number(block.mutation?.attrs[branches.attribute]) || 0, branches.most) : 0

function wayPlaces(block: Block, look: Look): Place[] {
  const { branches } = look
  if (!branches) return []
  return Array.from({ length: waysOf(block, look) }, (_, k) =>
    place(`${branches.value}${k + 1}`, ['Boolean']),
  )
}

function argPlaces(block: Block, { args }: Look): Place[] {
  if (!args) return []
  return (block.mutation?.args ?? []).map(({ type }, k) => place(`ARG${k}`, isKind(type) ? [type] : 'any'))
}

/** Every hole of a block, those that come with its mutation included. */
export function holesOf(block: Block, { look }: Definition): readonly Hole[] {
  const places = [namedPlaces, rowPlaces, wayPlaces, argPlaces].flatMap((find) => find(block, look))
  return places.map((hole) => ({ ...hole, child: plugged(block, hole.input) }))
}

/** Names of the inputs for rows of blocks that a block has now. */
export function statementNames(block: Block, look: Look): string[] {
  const named = look.inputs.filter((input) => input.kind === 'statements' && isThere(block, look, input))
  const more = Array.from({ length: waysOf(block, look) }, (_, k) => `DO${k + 1}`)
  return [...named.map(({ name }) => name), ...(look.branches ? more : [])]
}

/** Names of value and statement inputs that are filled in the file and that the block does not have. */
export function strangeInputs(block: Block, definition: Definition): readonly string[] {
  const values = new Set(holesOf(block, definition).map(({ input }) => input))
  const statements = new Set(statementNames(block, definition.look))
  return [
    ...Object.keys(block.values ?? {}).filter((name) => !values.has(name)),
    ...Object.keys(block.statements ?? {}).filter(
      (name) => !statements.has(name) && block.statements?.[name]?.length !== 0,
    ),
  ]
}
