import type { Database } from './database/database.ts'
import type { Wifi } from './database/tables.ts'
import type { Limits } from './limits.ts'
import type { Hub } from './live/hub.ts'
import type { LoadedForm } from '@botgarten/content/questionnaires'
import type { Question } from '@botgarten/content/questions'
import type { CheckProject } from './projects/checked.ts'
import type { SaveQueue } from './projects/save-queue.ts'
import type { Accounts } from './teaching/accounts.ts'

/** What is written to the log: routes and codes, never a name, an address or a code of a class. */
export interface LogLine {
  readonly method: string
  /** The route's pattern, such as `/projects/:project`: what stands in its place is left out. */
  readonly route: string
  readonly status: number
  /** A code of the database or the name of an error; never its message, which may hold a nickname. */
  readonly error?: string
}

/** A class, a pupil or a teacher that was deleted: the deletion is repeated after a backup was restored. */
export interface Tombstone {
  readonly kind: 'class' | 'pupil' | 'teacher'
  readonly id: string
}

/** A card in a table of results. */
export interface CardOfClass {
  readonly id: string
  /** Number of its start places. */
  readonly starts: number
  readonly title: { readonly [language: string]: string }
}

export interface Questionnaires {
  readonly forms: readonly LoadedForm[]
  readonly questions: readonly Question[]
}

/** How far a rehearsal is. */
export interface RehearsalProgress {
  readonly pupils: number
  readonly joined: number
  readonly saves: number
  /** The slowest save so far, ms. */
  readonly slowest: number
  /** Of the lesson so far, and of all of it, s. */
  readonly seconds: number
  readonly of: number
}

/** How a rehearsal went. */
export interface RehearsalOutcome {
  readonly green: boolean
  readonly pupils: number
  readonly saves: number
  /** Acknowledged saves that were not there at the end. */
  readonly lost: number
  /** 99 of 100 saves took at most so long, ms; and the slowest. */
  readonly p99: number
  readonly slowest: number
  /** Memory of its server at the most, MB. */
  readonly rss: number
}

export interface RehearsalWish {
  readonly pupils: number
  readonly seconds: number
}

/** What was found about the server or its machine. Words for it: `doctor.<verdict>`. */
export interface Finding<Verdict extends string = string> {
  /** Its thing and how that is, such as `port.taken`. */
  readonly verdict: Verdict
  /** Nothing has to be done. */
  readonly fine: boolean
  readonly facts: { readonly [name: string]: string | number }
}

/** The machine that the server runs on. */
export interface Host {
  /** Bytes that the process takes. */
  readonly memory: () => number
  /** Bytes that are free where the data lie. */
  readonly freeSpace: () => number
  /** Gives room back to a full disk, so that something can be deleted. @param bytes of the reserve; all of it if left out */
  readonly useReserve: (bytes?: number) => void
  /** Addresses under which it is reached. */
  readonly addresses: () => readonly string[]
  /** When another device last reached it, ms since 1970; null: none has. */
  readonly otherDevice: () => number | null
  /** A Wi-Fi that the machine itself makes, such as a Raspberry Pi; null: it makes none. */
  readonly wifi: Wifi | null
  /** Of the product: `0.1.0`. */
  readonly version: string
  /** How it is, as `botgarten doctor` sees it, and what only the running server knows. @param streams open ones */
  readonly findings: (streams: number) => readonly Finding[]
  /** Nightly copies; null where the database has tools of its own. */
  readonly backups: () => {
    readonly count: number
    /** Day of the newest. */
    readonly last: string | null
    /** Damaged databases that were set aside, and no backup was restored since. */
    readonly broken: number
  } | null
  /** Makes the copy of today. */
  readonly backUp: () => Promise<void>
  /** The newest copy, encrypted; null before the first one. */
  readonly newestBackup: () => {
    readonly name: string
    /** Bytes. */
    readonly size: number
    readonly body: ReadableStream<Uint8Array>
  } | null
  /**
   * Plays a lesson on a server of its own beside this one, whose data it never touches.
   * @param stop ends it early; its outcome is then rejected
   * @returns null where one is being played already
   */
  readonly rehearse: (
    wish: RehearsalWish,
    hear: (progress: RehearsalProgress) => void,
    stop: AbortSignal,
  ) => Promise<RehearsalOutcome> | null
}

/** What the class server needs of the outside. */
export interface Ports {
  readonly database: Database
  /** Milliseconds since 1970, UTC. */
  readonly now: () => number
  /** For durations, ms: it advances while the server runs, does not depend on its clock, and continues after a restart. */
  readonly steady: () => number
  /** The ISO day where the server stands, so many days from today. */
  readonly day: (offset: number) => string
  /** That many random bytes, good enough for secrets. */
  readonly random: (bytes: number) => Uint8Array
  /** Keys codes and pictures are hashed with; kept outside the database. At least 32 bytes. */
  readonly secret: Uint8Array
  readonly accounts: Accounts
  readonly checkProject: CheckProject
  readonly save: SaveQueue
  /** Keeps a tombstone beside the backups, before anything is deleted. */
  readonly bury: (tombstone: Tombstone) => Promise<void>
  readonly log: (line: LogLine) => void
  /** How pages reach the server where a proxy stands before it, such as `https://lab.example.org`; else null. */
  readonly publicOrigin: string | null
  /** The one address under which whoever asks should have the lab; null where it is not known. */
  readonly announced: (caller: Caller) => string | null
  /** The first teacher is there: the link that lies about is of no use any more. */
  readonly teacherMade: () => void
  /** How much one pupil may ask of this node. */
  readonly limits: Limits
  /** Who is where, and the streams of pages. */
  readonly live: Hub
  /** All cards, in the order of the home page. */
  readonly cards: () => Promise<readonly CardOfClass[]>
  /** The product's questionnaires, and the questions about what Bo does that a form may ask. */
  readonly questionnaires: () => Promise<Questionnaires>
  readonly host: Host
}

/** What the socket knows of a request, and no header may claim. */
export interface Caller {
  readonly address: string
  readonly secure: boolean
  /** This machine's own address that was asked; null behind a proxy. */
  readonly reached: string | null
}
