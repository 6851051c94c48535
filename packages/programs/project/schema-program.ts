import * as v from 'valibot'
import type { Block, Mutation } from '@botgarten/blocks'
import type { Program, Stack } from '../types.ts'
import { isReserved, longestId, longestKey, longestText } from './limits.ts'

export const textSchema = v.pipe(v.string(), v.maxLength(longestText))
/** Data of a block may be a whole network. */
const dataSchema = v.pipe(v.string(), v.maxLength(10 * longestText))
export const finite = v.pipe(v.number(), v.finite())

/** Names that are used as keys. */
export const idSchema = v.pipe(
  v.string(),
  v.maxLength(longestKey),
  v.check((id) => !isReserved(id), 'This name is reserved.'),
)
const filledId = v.pipe(idSchema, v.minLength(1), v.maxLength(longestId))

export const recordOf = <T extends v.GenericSchema>(schema: T) => v.record(idSchema, schema)

const mutationSchema: v.GenericSchema<Mutation> = v.object({
  attrs: recordOf(textSchema),
  args: v.exactOptional(v.array(v.object({ name: textSchema, type: textSchema }))),
})

/** Any type name: blocks that this version does not know are kept as they are. */
export const blockSchema: v.GenericSchema<Block> = v.object({
  id: filledId,
  type: filledId,
  fields: v.exactOptional(recordOf(textSchema)),
  mutation: v.exactOptional(mutationSchema),
  values: v.exactOptional(
    v.record(
      idSchema,
      v.lazy(() => blockSchema),
    ),
  ),
  statements: v.exactOptional(v.record(idSchema, v.array(v.lazy(() => blockSchema)))),
  comment: v.exactOptional(textSchema),
  data: v.exactOptional(dataSchema),
  hide: v.exactOptional(v.array(textSchema)),
  disabled: v.exactOptional(v.boolean()),
  collapsed: v.exactOptional(v.boolean()),
  inline: v.exactOptional(v.boolean()),
  shadow: v.exactOptional(v.boolean()),
  flags: v.exactOptional(recordOf(textSchema)),
})

const stackSchema: v.GenericSchema<Stack> = v.object({ x: finite, y: finite, blocks: v.array(blockSchema) })

function idsUnique(stacks: readonly Stack[]): boolean {
  const seen = new Set<string>()
  const fresh = (block: Block): boolean => {
    if (seen.has(block.id)) return false
    seen.add(block.id)
    return (
      Object.values(block.values ?? {}).every(fresh) &&
      Object.values(block.statements ?? {}).every((rows) => rows.every(fresh))
    )
  }
  return stacks.every(({ blocks }) => blocks.every(fresh))
}

const attributesSchema = recordOf(textSchema)

export const programSchema: v.GenericSchema<Program> = v.object({
  stacks: v.pipe(
    v.array(stackSchema),
    v.check((stacks) => idsUnique(stacks), 'Two blocks have the same id.'),
  ),
  config: v.object({ stacks: v.array(stackSchema) }),
  raw: v.exactOptional(
    v.object({
      attributes: attributesSchema,
      config: v.exactOptional(attributesSchema),
      root: v.exactOptional(attributesSchema),
    }),
  ),
})
