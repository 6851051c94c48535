import * as v from 'valibot'

// What the class server answers a teacher's page. Fields that a newer server adds are left out.

const list = <const Item extends v.GenericSchema>(item: Item) => v.array(item)

export const serverState = v.object({
  firstTeacher: v.nullable(v.object({ madeAt: v.number() })),
  secure: v.boolean(),
  teacher: v.nullable(v.object({ username: v.string(), operator: v.boolean() })),
  substitute: v.nullable(v.object({ class: v.string(), name: v.string() })),
  /** The one address that devices of the room should use; null: not known. */
  address: v.nullable(v.string()),
})

const teacherRow = v.object({
  id: v.string(),
  username: v.string(),
  operator: v.boolean(),
  /** Numbers of classes and of pupils in them. */
  classes: v.number(),
  pupils: v.number(),
})
export type TeacherRow = v.InferOutput<typeof teacherRow>
export const teachersAnswer = v.object({ teachers: list(teacherRow) })

const schoolClass = v.object({
  id: v.string(),
  name: v.string(),
  language: v.string(),
  grade: v.number(),
  /** Its words by their first four letters. */
  code: v.string(),
  /** The same as complete words. */
  words: list(v.string()),
  open: v.boolean(),
  /** Until when newcomers can join, in ms since 1970. */
  joiningUntil: v.nullable(v.number()),
  /** ISO day. */
  endsOn: v.string(),
  endsSoon: v.boolean(),
  /** It has ended by the date of the server and is not deleted yet. */
  hidden: v.optional(v.boolean(), false),
  /** Ids of the cards that are free today; null: all. */
  cards: v.nullable(list(v.string())),
  /** Which blocks there are; null: as each child chooses. */
  level: v.nullable(v.picklist(['plain', 'all'])),
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

const check = v.picklist(['open', 'passed', 'failed'])
const live = v.object({
  card: v.nullable(v.string()),
  project: v.nullable(v.string()),
  checks: list(check),
  failed: v.number(),
  running: v.boolean(),
  size: v.nullable(v.tuple([v.number(), v.number()])),
  pose: v.nullable(v.object({ x: v.number(), y: v.number(), heading: v.number() })),
  trail: list(v.number()),
  seenAt: v.number(),
  changedAt: v.number(),
})

const tile = v.object({
  id: v.string(),
  nickname: v.string(),
  isNew: v.boolean(),
  locked: v.boolean(),
  handAt: v.nullable(v.number()),
  live: v.nullable(live),
})

/** Events of the live view: all of it, and what pupils' pages report in between. */
export const liveState = v.object({
  now: v.number(),
  class: schoolClass,
  /** Seconds for which attention is asked; null: it is not. */
  attention: v.nullable(v.number()),
  tiles: list(tile),
})
export const liveTiles = v.object({
  now: v.number(),
  tiles: list(v.object({ id: v.string(), live })),
})
export const liveEnd = v.object({ reason: v.string() })

/** A pupil's project as the class has it; `project` is left out where the page has this revision. */
export const insideAnswer = v.object({
  seconds: v.number(),
  project: v.nullable(
    v.object({ id: v.string(), revision: v.number(), savedAt: v.number(), project: v.unknown() }),
  ),
})

export const results = v.object({
  free: v.nullable(list(v.string())),
  pupils: list(
    v.object({
      id: v.string(),
      nickname: v.string(),
      /** From how many start places of each card that was begun. */
      done: v.record(v.string(), v.number()),
    }),
  ),
})
export type Results = v.InferOutput<typeof results>

const backups = v.nullable(
  v.object({
    count: v.number(),
    last: v.nullable(v.string()),
    /** Damaged databases that were set aside; an older server does not count them. */
    broken: v.optional(v.number()),
  }),
)

export const data = v.object({
  pupils: v.number(),
  projects: v.number(),
  versions: v.number(),
  /** Things in the gallery. */
  shared: v.number(),
  results: v.number(),
  /** Questionnaires that the class was asked; a server that is older asks none. */
  forms: v.optional(v.number(), 0),
  /** Bytes, and how many there may be. */
  space: v.number(),
  mostSpace: v.number(),
  endsOn: v.string(),
  backups,
  /** Deleted today, the class is in no backup from the server's first start or night on that this day has. */
  goneFromBackupsOn: v.string(),
})
export type Data = v.InferOutput<typeof data>

export const health = v.object({
  now: v.number(),
  secure: v.boolean(),
  database: v.string(),
  /** Bytes. */
  memory: v.number(),
  freeSpace: v.number(),
  addresses: list(v.string()),
  /** When a device other than the server's own last reached it, ms since 1970; null: none has. */
  otherDevice: v.nullable(v.number()),
  /** Pages of pupils and teachers that are connected now. */
  streams: v.number(),
  version: v.string(),
  backups,
})
export type Health = v.InferOutput<typeof health>
const finding = v.object({
  verdict: v.string(),
  fine: v.boolean(),
  facts: v.record(v.string(), v.union([v.string(), v.number()])),
})
export type Finding = v.InferOutput<typeof finding>
export const findings = v.object({ findings: list(finding) })
export const sizes = v.object({ classes: list(v.object({ space: v.number(), pupils: v.number() })) })

export const clock = v.object({
  /** ISO days: of the clock, and the last one before on which the server ran; null: it never ran before. */
  today: v.string(),
  last: v.nullable(v.string()),
  doubted: v.boolean(),
  /** The operator has answered that the clock is wrong. */
  denied: v.boolean(),
  /** Different days of running since the doubt began. */
  days: v.number(),
  /** Classes that have ended if the clock is right. */
  ended: v.number(),
})
export type Clock = v.InferOutput<typeof clock>

export const backedUp = v.object({ backups })
/** Ten words with hyphens. */
export const phraseAnswer = v.object({ phrase: v.string() })

const wifi = v.object({
  name: v.string(),
  /** Empty: it is open to all. */
  password: v.string(),
})
export type Wifi = v.InferOutput<typeof wifi>
export const wifiAnswer = v.object({ wifi: v.nullable(wifi) })

/** How far a rehearsal is; times of saves in ms. */
export const rehearsalProgress = v.object({
  pupils: v.number(),
  joined: v.number(),
  saves: v.number(),
  slowest: v.number(),
  seconds: v.number(),
  of: v.number(),
})
export const rehearsalOutcome = v.object({
  green: v.boolean(),
  pupils: v.number(),
  saves: v.number(),
  lost: v.number(),
  p99: v.number(),
  slowest: v.number(),
})

export const substituteLink = v.object({ token: v.string(), day: v.string() })
export const substituteOf = v.object({ id: v.string(), name: v.string() })
