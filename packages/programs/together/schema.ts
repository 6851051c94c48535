import * as v from 'valibot'
import { refuseOversize } from '../project/limits.ts'
import { blockSchema, finite, idSchema, programSchema, textSchema } from '../project/schema-program.ts'
import { parts, type Place } from './types.ts'

/** How many operations are sent at once at the most. */
export const mostAtOnce = 500

const id = v.pipe(idSchema, v.minLength(1))
const x = v.pipe(finite, v.minValue(-1e6), v.maxValue(1e6))

const place: v.GenericSchema<Place> = v.union([
  v.strictObject({ x, y: x }),
  v.strictObject({ after: id }),
  v.strictObject({ before: id }),
  v.strictObject({ in: id, statement: id }),
  v.strictObject({ in: id, value: id }),
])
const path = v.pipe(v.array(id), v.minLength(1), v.maxLength(6))

const operation = v.variant('kind', [
  v.strictObject({ kind: v.literal('add'), program: id, block: blockSchema, place }),
  v.strictObject({ kind: v.literal('move'), program: id, block: id, place }),
  v.strictObject({ kind: v.literal('delete'), program: id, block: id }),
  v.strictObject({
    kind: v.literal('field'),
    program: id,
    block: id,
    name: id,
    value: v.nullable(textSchema),
  }),
  v.strictObject({
    kind: v.literal('part'),
    program: id,
    block: id,
    name: v.picklist(parts),
    value: v.unknown(),
  }),
  v.strictObject({ kind: v.picklist(['knob', 'thing']), path, value: v.unknown() }),
  v.strictObject({ kind: v.literal('program'), program: id, value: v.nullable(programSchema) }),
])

function isSmall(data: unknown): boolean {
  try {
    refuseOversize(data)
    return true
  } catch {
    return false
  }
}

const count = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(1_000_000))

/** What one of the two sends: nothing of it is trusted. */
export const sendingSchema = v.pipe(
  v.unknown(),
  // Before anything walks through it by recursion.
  v.check(isSmall, 'It is nested too deeply, or a name in it is reserved.'),
  v.strictObject({
    ops: v.pipe(
      v.array(v.strictObject({ n: count, base: count, op: operation })),
      v.minLength(1),
      v.maxLength(mostAtOnce),
    ),
  }),
)
