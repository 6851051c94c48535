import * as v from 'valibot'
import { pauseOf, type Pause } from './sending.ts'
import { read, type Ask } from './ask.ts'

const schema = v.object({
  id: v.string(),
  nickname: v.string(),
  /** Has joined or shown the pictures within this lesson. */
  fresh: v.boolean(),
  hand: v.boolean(),
  class: v.object({ id: v.string(), name: v.string(), open: v.boolean() }),
})

export type Me = v.InferOutput<typeof schema>

/** Who this is by the class, or why the class does not answer. */
export async function fetchMe(ask: Ask): Promise<Me | Pause> {
  const reply = await ask('GET', '/me')
  return read(schema, reply) ?? pauseOf(reply)
}

/** What becomes of a child that answers yes. `locked`: a lesson is over, and the class cannot be asked for the pictures. */
export type Passage = 'through' | 'pictures' | 'locked' | 'signedOut' | 'ended'

export function passage(me: Me | Pause, isProven: boolean): Passage {
  if (typeof me === 'object') return me.fresh ? 'through' : 'pictures'
  if (me === 'ended') return 'ended'
  if (me === 'signedOut' || me === 'otherPupil') return 'signedOut'
  return isProven ? 'through' : 'locked'
}
