import * as v from 'valibot'

export const otherHand = v.object({
  program: v.nullable(v.string()),
  at: v.nullable(v.string()),
  x: v.number(),
  y: v.number(),
  chosen: v.nullable(v.string()),
})
/** Over which block of which program a hand is, at which share of its size, and which block it has chosen. */
export type OtherHand = v.InferOutput<typeof otherHand>
