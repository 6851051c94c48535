import { definitions, isBlockType, plugged, rowCount, rowName } from '@botgarten/blocks'
import type { Block, Definition, Face, Look, ValueType } from '@botgarten/blocks'

export const definitionOf = ({ type }: Block): Definition | null =>
  isBlockType(type) ? definitions[type] : null

function faceOf(block: Block, { faces, fields }: Look): Face | undefined {
  if (!faces) return undefined
  const { by } = faces
  if ('attribute' in by) return own(faces.of, block.mutation?.attrs[by.attribute])
  const look = fields.find(({ name }) => name === by.field)
  return own(faces.of, block.fields?.[by.field] ?? String(look?.preset))
}

const own = <T>(record: { readonly [name: string]: T }, name: string | undefined): T | undefined =>
  name !== undefined && Object.hasOwn(record, name) ? record[name] : undefined

/** The kind of value a block gives; undefined for blocks that give none. */
export const outputOf = (block: Block, { look }: Definition): ValueType | undefined =>
  faceOf(block, look)?.output ?? look.output

/** A hole for a value: what stands in it, and what may. */
export interface Hole {
  readonly input: string
  readonly child: Block | undefined
  readonly accepts: readonly ValueType[]
  readonly optional: boolean
}

/** Every hole of a block, the rows of a growing list included. */
export function holesOf(block: Block, { look }: Definition): readonly Hole[] {
  const named = look.inputs.flatMap((input) =>
    input.kind === 'value'
      ? [{ input: input.name, accepts: input.accepts, optional: input.optional === true }]
      : [],
  )
  const rows = rowsOf(block, look).map((input) => ({
    input,
    accepts: faceOf(block, look)?.items?.accepts ?? [],
    optional: true,
  }))
  return [...named, ...rows].map((hole) => ({ ...hole, child: plugged(block, hole.input) }))
}

const rowsOf = (block: Block, { items }: Look): readonly string[] =>
  items ? Array.from({ length: rowCount(block) }, (_, k) => rowName(k)) : []

/** Names of value and statement inputs that are filled in the file and that the block does not have. */
export function strangeInputs(block: Block, definition: Definition): readonly string[] {
  const known = new Set([
    ...holesOf(block, definition).map(({ input }) => input),
    ...definition.look.inputs.map(({ name }) => name),
  ])
  return [...Object.keys(block.values ?? {}), ...Object.keys(block.statements ?? {})].filter(
    (name) => !known.has(name),
  )
}
