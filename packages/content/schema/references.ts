import * as v from 'valibot'
import { checked, https } from './checked.ts'

const reference = v.strictObject({
  address: https,
  title: v.string(),
  /** Who made it. */
  by: v.string(),
  /** As its makers name it; `not checked` where nobody has looked it up. */
  licence: v.pipe(v.string(), v.minLength(1)),
  /** Where address, title and licence were looked up. */
  checked,
})

const references = v.array(reference)

export type Reference = v.InferOutput<typeof reference>

/** Reads `content/materials/references.json`: what others made and materials lead to. @throws ValiError that names the place where the file is wrong. */
export const readReferences = (json: unknown): readonly Reference[] => v.parse(references, json)
