import * as v from 'valibot'
import { pauseOf, type Pause } from './sending.ts'
import { read, type Ask } from '#storage/ask.ts'

const handout = v.object({
  id: v.string(),
  kind: v.picklist(['hint', 'program']),
  /** Card of a hint or of a start program; null: own words, or a project. */
  card: v.nullable(v.string()),
  /** The n-th hint of the card, from 1. */
  hint: v.nullable(v.number()),
  /** Own words, or the name of a project. */
  text: v.nullable(v.string()),
})

/** Two on one program. `me`: which of the two this pupil is, `a` has invited; `over`: the other one has left. */
export const pair = v.object({
  id: v.string(),
  title: v.string(),
  with: v.string(),
  me: v.picklist(['a', 'b']),
  accepted: v.boolean(),
  role: v.picklist(['hand', 'eye']),
  over: v.boolean(),
})
export type Pair = v.InferOutput<typeof pair>

export const me = v.object({
  id: v.string(),
  nickname: v.string(),
  /** Has joined or shown the pictures within this lesson. */
  fresh: v.boolean(),
  hand: v.boolean(),
  class: v.object({
    id: v.string(),
    name: v.string(),
    open: v.boolean(),
    /** Ids of the cards that are open today; null: all. */
    cards: v.nullable(v.array(v.string())),
    /** Which blocks there are; null: as the child likes. */
    level: v.nullable(v.picklist(['plain', 'all'])),
    /** Is there a gallery of what pupils share? May they ask each other? */
    gallery: v.boolean(),
    asking: v.boolean(),
    /** May two work on one program? A class that does not say so does not offer it. */
    together: v.optional(v.boolean(), false),
  }),
  /** For so many seconds at the most the teacher wants to be looked at. */
  attention: v.nullable(v.number()),
  /** A teacher looks at this pupil's work; no name: a substitute. */
  inside: v.nullable(v.object({ by: v.nullable(v.string()) })),
  /** What the teacher has sent and the child has not put away, the oldest first. */
  handouts: v.array(handout),
  /** Of the newest change of this pupil's projects in the class. An older server gives none. */
  mark: v.optional(v.nullable(v.string())),
  /** The questionnaire that the class is asked now, by its key. A server that is older asks none. */
  asking: v.optional(v.nullable(v.string()), null),
  /** The classmate with whom this pupil works on one program, or who asks to. An older server has none. */
  pair: v.optional(v.nullable(pair), null),
  /** What this pupil asks a classmate; no answer: not yet. */
  asked: v.nullable(
    v.object({ to: v.string(), card: v.string(), answer: v.nullable(v.picklist(['coming', 'notNow'])) }),
  ),
  /** What classmates ask this one, the first first. */
  questions: v.array(v.object({ id: v.string(), by: v.string(), card: v.string() })),
})

export type Me = v.InferOutput<typeof me>
export type Handout = Me['handouts'][number]

/** Who this is by the class, or why the class does not answer. */
export async function fetchMe(ask: Ask): Promise<Me | Pause> {
  const reply = await ask('GET', '/me')
  return read(me, reply) ?? pauseOf(reply)
}

/**
 * What becomes of a child that answers yes. `locked`: a lesson is over, and the class cannot be asked for the pictures ·
 * `hidden`: the class has ended by the date of the server, and may be shown again.
 */
export type Passage = 'through' | 'pictures' | 'locked' | 'signedOut' | 'ended' | 'hidden'

export function passage(me: Pick<Me, 'fresh'> | Pause, isProven: boolean): Passage {
  if (typeof me === 'object') return me.fresh ? 'through' : 'pictures'
  if (me === 'ended' || me === 'hidden') return me
  if (me === 'signedOut' || me === 'otherPupil') return 'signedOut'
  return isProven ? 'through' : 'locked'
}
