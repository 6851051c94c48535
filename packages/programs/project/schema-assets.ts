import * as v from 'valibot'

const sha256 = v.pipe(v.string(), v.regex(/^[0-9a-f]{64}$/))
const base64 = v.pipe(v.string(), v.regex(/^[A-Za-z0-9+/]*={0,2}$/))
const asset = v.object({ type: v.literal('image/png'), base64 })

/** Pictures by their hash. */
export const assetsSchema = v.record(sha256, asset)
