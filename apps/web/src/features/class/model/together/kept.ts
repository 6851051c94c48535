import { ownName } from '#storage/account.ts'
import * as v from 'valibot'
import type { Entry } from '@botgarten/programs/together'

// Which project of this device belongs to a pair, and what of it the class has not got yet.

const schema = v.object({
  pair: v.string(),
  project: v.string(),
  card: v.string(),
  /** Made here by the lab itself. */
  pending: v.array(v.custom<Entry>((one) => typeof one === 'object' && one !== null)),
  /** So many entries of the common order were shown here, one after the other: the last few. */
  shown: v.optional(v.array(v.number()), [0]),
})
export type Kept = v.InferOutput<typeof schema>

const key = () => ownName('botgarten-pair')

export function kept(): Kept | null {
  try {
    const found = v.safeParse(schema, JSON.parse(localStorage.getItem(key()) ?? 'null'))
    return found.success ? found.output : null
  } catch {
    return null
  }
}

export function keep(next: Kept | null): void {
  try {
    if (next) localStorage.setItem(key(), JSON.stringify(next))
    else localStorage.removeItem(key())
  } catch {
    // What the class has not got yet is lost with this page then; it is in the project all the same.
  }
}
