import * as v from 'valibot'

export const https = v.pipe(v.string(), v.regex(/^https:\/\/[^\s]+$/))

/** Where a name, a number or an address was looked up, and the day: or plainly that nobody has. */
export const checked = v.union([
  v.literal('not checked'),
  v.strictObject({ at: https, on: v.pipe(v.string(), v.isoDate()) }),
])

export type Checked = v.InferOutput<typeof checked>
