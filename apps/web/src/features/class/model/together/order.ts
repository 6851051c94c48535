// The common order as the class tells it.
import type { Entry } from '@botgarten/programs/together'
import * as v from 'valibot'
import { read, type Ask, type Reply } from '#storage/ask.ts'
import { pair } from '../pupil.ts'

const entries = v.array(v.custom<Entry>((one) => typeof one === 'object' && one !== null))
const state = v.object({ ...pair.entries, length: v.number(), entries })
const beginning = v.object({ ...state.entries, project: v.unknown() })

export type Beginning = v.InferOutput<typeof beginning>

/** What is new from a place of the order on. */
export async function fetchFrom(ask: Ask, id: string, from: number) {
  const reply: Reply = await ask('GET', `/pair?from=${from}`)
  const found = read(state, reply)
  return { reply, found: found?.id === id ? found : null }
}

/** What the two began with and the whole order since; null: it did not come whole. */
export async function fetchBeginning(ask: Ask, id: string): Promise<Beginning | null> {
  const found = read(beginning, await ask('GET', '/pair'))
  if (found?.id !== id) return null
  const order = [...found.entries]
  while (order.length < found.length) {
    const next = (await fetchFrom(ask, id, order.length)).found
    if (!next || next.entries.length === 0) return null
    order.push(...next.entries)
  }
  return { ...found, entries: order }
}
