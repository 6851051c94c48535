import * as v from 'valibot'

// What the class server answers a teacher of its questionnaires. Fields that a newer server adds are left out.

const asking = v.object({
  form: v.unknown(),
  text: v.unknown(),
  state: v.picklist(['open', 'closing', 'closed']),
  /** While it closes: so long what is on its way is still taken. */
  seconds: v.nullable(v.number()),
  /** How many have answered; null: some, and fewer than five. */
  came: v.nullable(v.number()),
  /** Sheets of paper that were typed in. */
  paper: v.optional(v.number(), 0),
})
export const askings = v.object({ askings: v.array(asking) })

const bands = v.array(v.picklist(['3-4', '5-6', '7-9', '10-12']))
const tally = v.object({
  ...{ bands, n: v.number() },
  counts: v.record(v.string(), v.array(v.number())),
  open: v.record(v.string(), v.array(v.string())),
})
const test = v.object({
  ...{ n: v.number(), plus: v.number(), minus: v.number(), r: v.number() },
  p: v.nullable(v.number()),
  smallest: v.number(),
})
const growth = v.object({
  ...{ n: v.number(), of: v.number(), test: v.nullable(test) },
  scores: v.array(v.tuple([v.number(), v.number()])),
})

export const results = v.object({
  forms: v.array(v.object({ form: v.string(), tallies: v.array(tally) })),
  growths: v.array(v.object({ before: v.string(), after: v.string(), growth })),
})
export type ClassResults = v.InferOutput<typeof results>

/** Of a class. */
export const pupils = v.object({ pupils: v.array(v.object({ id: v.string(), nickname: v.string() })) })

export const rows = v.object({ rows: v.array(v.array(v.union([v.string(), v.number()]))) })
