import * as v from 'valibot'

// What the class server answers a teacher's page. Fields that a newer server adds are left out.

const list = <const Item extends v.GenericSchema>(item: Item) => v.array(item)

export const serverState = v.object({
  firstTeacher: v.nullable(v.object({ name: v.nullable(v.string()), madeAt: v.number() })),
  secure: v.boolean(),
  teacher: v.nullable(v.object({ username: v.string(), operator: v.boolean() })),
})

const schoolClass = v.object({
  id: v.string(),
  name: v.string(),
  language: v.string(),
  grade: v.number(),
  /** Three words by their first four letters. */
  code: v.string(),
  /** The same as whole words. */
  words: list(v.string()),
  open: v.boolean(),
  /** Until when newcomers can join, in ms since 1970. */
  joiningUntil: v.nullable(v.number()),
  /** ISO day. */
  endsOn: v.string(),
  endsSoon: v.boolean(),
})
export type SchoolClass = v.InferOutput<typeof schoolClass>

export const classes = v.object({ classes: list(schoolClass) })

export const classInFull = v.object({
  ...schoolClass.entries,
  pupils: v.number(),
  projects: v.number(),
  versions: v.number(),
  /** Bytes, and how many there may be. */
  space: v.number(),
  mostSpace: v.number(),
})
export type ClassInFull = v.InferOutput<typeof classInFull>

export const made = v.object({ id: v.string() })
export const opened = v.object({ joiningUntil: v.number() })
export const invitation = v.object({ token: v.string(), endsAt: v.number() })
export const pictures = v.object({ pictures: list(v.string()) })

const pupil = v.object({
  id: v.string(),
  nickname: v.string(),
  lockedAt: v.nullable(v.number()),
  handAt: v.nullable(v.number()),
  isNew: v.number(),
})
export type Pupil = v.InferOutput<typeof pupil>
export const pupils = v.object({ pupils: list(pupil) })
