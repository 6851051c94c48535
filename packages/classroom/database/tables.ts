import type { Generated, Insertable, Selectable } from 'kysely'
import type { GalleryTables } from './gallery-tables.ts'
import type { PairEntryTable, PairTable } from './together-tables.ts'

// Ids are text; times are milliseconds since 1970; booleans are 0 or 1: so one set of queries serves both databases.

interface TeacherTable {
  id: string
  name: string
  email: string
  emailVerified: unknown
  image: string | null
  createdAt: unknown
  updatedAt: unknown
  username: string
  displayUsername: string | null
}

/** Who may invite teachers, and since when. */
interface OperatorTable {
  teacher: string
  madeAt: number
}

interface TeacherSessionTable {
  id: string
  userId: string
  expiresAt: unknown
}

interface AccountTable {
  id: string
  userId: string
  password: string | null
}

/** A link that makes one teacher, once. */
interface InvitationTable {
  tokenHash: string
  first: 0 | 1
  /** Ms since 1970; for the first teacher of the steady clock. */
  endsAt: number
}

export interface ClassTable {
  id: string
  teacher: string
  name: string
  /** `de` or `en`: of the words of the code. */
  language: string
  grade: number
  /** Its words by their first four letters: `kite-otte-plum-rose`; of older classes three. */
  code: string
  /** Of the steady clock. */
  joiningUntil: number
  openedAt: number | null
  /** No longer read: until lessons were counted it decided who had shown the pictures in this one. */
  closedAt: Generated<number>
  /** One more with each lesson that was closed. */
  lesson: Generated<number>
  /** ISO day. */
  endsOn: string
  /** No longer read: classes end by the calendar. */
  announcedDay: number | null
  /** Bytes of its versions and assets. */
  space: number
  madeAt: number
  /** JSON: ids of the cards that are free today; null: all. */
  cards: string | null
  /** `plain` or `all`: which blocks there are; null: as each child chooses. */
  level: string | null
  /** Is there a gallery of what pupils share? */
  gallery: Generated<0 | 1>
  /** May pupils ask each other? */
  asking: Generated<0 | 1>
  /** May two work on one program? */
  together: Generated<0 | 1>
}

interface PupilTable {
  id: string
  class: string
  nickname: string
  /** Nickname after NFKC and case folding. */
  nicknameKey: string
  /** Keyed hash of the three pictures in their order. */
  pictures: string
  /** No longer read: wrong tries are counted in `attempt`. */
  wrong: number
  lockedAt: number | null
  handAt: number | null
  isNew: 0 | 1
  joinedAt: number
  /** How often its projects have changed: the number of its newest mark. */
  changes: Generated<number>
  /** Bytes of its versions and its shared projects, and of the pictures in both. */
  space: Generated<number>
}

/** Each change of a pupil's projects leaves one; a device that shows an unknown one comes from before a restore. */
interface MarkTable {
  pupil: string
  /** From 1, one more with each change. */
  number: number
  random: string
}

interface PupilSessionTable {
  tokenHash: string
  pupil: string
  class: string
  /** When the pupil joined or showed the pictures. */
  provenAt: number
  /** The same by the steady clock; null for a session of an earlier version. */
  provenSteady: number | null
  /** The lesson of the class in which that was. */
  lesson: number
}

interface ProjectTable {
  pupil: string
  id: string
  class: string
  revision: number
  name: string
  card: string | null
  savedAt: number
}

/** A project that its pupil has thrown away and not restored. */
interface ThrownTable {
  pupil: string
  project: string
  /** Its last one: when restored, it goes on from there, so that a late request never takes it for the former. */
  revision: number
}

interface VersionTable {
  pupil: string
  project: string
  revision: number
  class: string
  savedAt: number
  /** Ms of the steady clock; null for versions of an earlier program, whose `savedAt` is comparable with it. */
  savedSteady: number | null
  bytes: number
  hash: string
  /** The project without the content of its assets. */
  document: string
}

/** Which save became which revision: a save that is sent twice is one. */
interface AnsweredTable {
  pupil: string
  save: string
  project: string
  revision: number
  savedAt: number
}

interface AssetTable {
  class: string
  hash: string
  type: string
  base64: string
}

interface VersionAssetTable {
  pupil: string
  project: string
  revision: number
  class: string
  /** By which the project names it. */
  name: string
  /** Of its content. */
  hash: string
}

/** Wrong pictures, and new pupils of a device, by keyed hashes. */
interface AttemptTable {
  key: string
  count: number
  endsAt: number
}

/** What a teacher sent: a hint or a program. It stays until the child has put it away. */
export interface HandoutTable {
  id: string
  class: string
  kind: 'hint' | 'program'
  card: string | null
  /** The n-th hint of the card, from 1. */
  hint: number | null
  text: string | null
  /** A project. */
  document: string | null
  at: number
}

interface HandoutToTable {
  handout: string
  pupil: string
}

/** From how many of a card's start places a pupil has passed, at the best of times. */
interface ResultTable {
  pupil: string
  card: string
  class: string
  done: number
}

/** A link for one class that works on one day. */
interface SubstituteTable {
  tokenHash: string
  class: string
  day: string
}

/** What a device needs to get into the Wi-Fi of the room; no password: it is open to all. */
export interface Wifi {
  name: string
  password: string
}

/** A pupil was given the one token for a form. Nothing leads from here to an answer. */
interface TokenTable {
  pupil: string
  form: string
  /** Hash of the blinded input; null: the pupil may be given the token for another one. */
  blinded: string | null
  /** 1: the teacher has allowed another input. It is allowed once. */
  again: Generated<number>
}

interface WifiTable extends Wifi {
  teacher: string
}

interface MetaTable {
  key: string
  value: string
}

interface TombstoneTable {
  kind: string
  id: string
}

export interface Tables extends GalleryTables {
  teacher: TeacherTable
  operator: OperatorTable
  teacherSession: TeacherSessionTable
  account: AccountTable
  invitation: InvitationTable
  class: ClassTable
  pupil: PupilTable
  pupilSession: PupilSessionTable
  project: ProjectTable
  thrown: ThrownTable
  mark: MarkTable
  version: VersionTable
  answered: AnsweredTable
  asset: AssetTable
  versionAsset: VersionAssetTable
  attempt: AttemptTable
  handout: HandoutTable
  handoutTo: HandoutToTable
  result: ResultTable
  substitute: SubstituteTable
  wifi: WifiTable
  token: TokenTable
  pair: PairTable
  pairEntry: PairEntryTable
  meta: MetaTable
  tombstone: TombstoneTable
}

export type ClassRow = Selectable<ClassTable>
export type PupilRow = Selectable<PupilTable>
export type NewPupil = Insertable<PupilTable>
