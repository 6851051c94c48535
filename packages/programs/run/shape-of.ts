import type { Block, Look, Shape, When } from '@botgarten/blocks'

/** Does a field of the block, or an attribute of its mutation, say one of these? */
export function holds(block: Block, when: When, look: Look): boolean {
  if ('attribute' in when) return when.is.includes(block.mutation?.attrs[when.attribute] ?? '')
  const field = look.fields.find(({ name }) => name === when.field)
  return when.is.includes(block.fields?.[when.field] ?? String(field?.preset ?? ''))
}

export const shapeOf = (block: Block, look: Look): Shape =>
  look.also && holds(block, look.also.when, look) ? look.also.shape : look.shape
