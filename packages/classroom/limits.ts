import { mostOfProject } from './body.ts'
import { Buckets } from './buckets.ts'
import { Counters } from './counters.ts'
import { FairQueue } from './fair-queue.ts'
import { Guesses, type Pace } from './joining/guesses.ts'
import { Refusal } from './refusal.ts'
import { Refused } from './refused.ts'
import { Slots } from './slots.ts'

/** Amounts for a pupil or a class: at once, and how much more each second. */
const paces = {
  /** Requests of a pupil: a page sends about one a second. */
  requests: { atOnce: 300, eachSecond: 30 },
  /** Requests of all pupils of a class. */
  requestsOfClass: { atOnce: 2000, eachSecond: 200 },
  /** Bytes of projects of a pupil: two of the largest, and one with a photo every four seconds. Each MB takes the disk some 10 ms. */
  bytes: { atOnce: 10_000_000, eachSecond: 250_000 },
  /** Changes of a pupil's hearts: each is written to the disk, and all pages of the class load the gallery again. */
  hearts: { atOnce: 30, eachSecond: 0.5 },
  /** Raised and lowered hands of a pupil: each is written to the disk, and the teacher's page gets the class again. */
  hands: { atOnce: 20, eachSecond: 0.5 },
} as const satisfies { readonly [of: string]: Pace }

/** Most that is open at the same time. */
const most = {
  /** A child has a device or two, and a stream that died unnoticed ends after minutes. */
  streams: 8,
  streamsOfClass: 200,
  /** Bytes of projects on their way: two of the largest. */
  bytes: 10_000_000,
  bytesOfClass: 40_000_000,
  /** Files with the data of a class or a pupil, of one teacher; further ones wait. */
  exports: 2,
  waitingExports: 20,
} as const

/** Requests that an open stream counts as: each reads the whole state of its pupil. */
const ofStream = 20

/**
 * Wrong tries that a node answers, in all. Codes of four words: 25 million a day. Codes of three words, which
 * older classes have: as many as those were made for. Passwords: each costs the work of a hash.
 */
const wrongTries = {
  codes: { atOnce: 1500, eachSecond: 289 },
  shortCodes: { atOnce: 1000, eachSecond: 1000 / 600 },
  pictures: { atOnce: 500, eachSecond: 20 },
  signIns: { atOnce: 100, eachSecond: 2 },
  knownSignIns: { atOnce: 40, eachSecond: 2 },
} as const satisfies { readonly [of: string]: Pace }

type GuessesOf = { readonly [of in keyof typeof wrongTries]: Guesses }

/** A pupil and her class. */
export interface Sender {
  readonly id: string
  readonly class: string
}

/**
 * Bounds the load that one pupil, one class or one teacher can put on a node, so that the other classes on it stay as fast as
 * before. Each node has its own.
 */
export class Limits {
  private readonly requests: Buckets
  private readonly requestsOfClass: Buckets
  private readonly bytes: Buckets
  private readonly hearts: Buckets
  private readonly hands: Buckets
  private readonly open = new Counters()
  private readonly refused: Refused
  /** In which pupils join. */
  readonly joins = new FairQueue()
  /** In which the files of a teacher are written. */
  readonly exports = new Slots(most.exports, most.waitingExports)
  /** Of everyone: codes, pictures and passwords that were wrong. */
  readonly guesses: GuessesOf

  /** @param elapsed ms of a clock that never goes back */
  constructor(elapsed: () => number) {
    const buckets = (of: keyof typeof paces) => new Buckets(elapsed, paces[of])
    this.requests = buckets('requests')
    this.requestsOfClass = buckets('requestsOfClass')
    this.bytes = buckets('bytes')
    this.hearts = buckets('hearts')
    this.hands = buckets('hands')
    this.refused = new Refused(elapsed)
    const pace = (of: keyof typeof wrongTries) => new Guesses(elapsed, wrongTries[of])
    this.guesses = {
      ...{ codes: pace('codes'), shortCodes: pace('shortCodes'), pictures: pace('pictures') },
      ...{ signIns: pace('signIns'), knownSignIns: pace('knownSignIns') },
    }
  }

  /** How many pupils are remembered. */
  get size(): number {
    return this.requests.size
  }

  /** Counts a request of a pupil, or of an address. @throws Refusal 429 if it has sent too many of late */
  request(sender: string, cost = 1): void {
    const seconds = this.requests.take(sender, cost)
    if (seconds > 0) throw new Refusal(429, 'tooFast', { seconds })
  }

  /**
   * Refuses a device that has just been refused for its many requests, before it is known whose it is: that is a query.
   * @param session the token of a pupil; null: none
   * @throws Refusal 429
   */
  refuseEarly(session: string | null): void {
    const seconds = session === null ? 0 : this.refused.secondsOf(session)
    if (seconds > 0) throw new Refusal(429, 'tooFast', { seconds })
  }

  /** Notes a device that was refused. @param seconds until it may send again */
  noteRefused(session: string, seconds: number): void {
    this.refused.note(session, seconds)
  }

  /** Counts a request of a pupil, and of her class. @throws Refusal 429 if either has sent too many of late */
  requestOf({ id, class: classId }: Sender): void {
    this.request(id)
    const seconds = this.requestsOfClass.take(classId)
    if (seconds > 0) throw new Refusal(429, 'classTooFast', { seconds })
  }

  /** Counts a stream of a pupil. @returns a function for its end @throws Refusal 429 if she, or her class, has too many */
  stream({ id, class: classId }: Sender): () => void {
    this.request(id, ofStream)
    const own = this.open.enter(`streams ${id}`, 1, most.streams)
    const all = own && this.open.enter(`streams of ${classId}`, 1, most.streamsOfClass)
    if (own && all) return () => (own(), all())
    own?.()
    throw new Refusal(429, 'tooManyStreams', { seconds: 60 })
  }

  /**
   * Counts a project that a pupil begins to send.
   * @param announced bytes
   * @returns a function for its end
   * @throws Refusal 429 if too much of hers, or of her class, is on its way, or was of late
   */
  upload({ id, class: classId }: Sender, announced: number): () => void {
    // A longer one is cut off there.
    const bytes = Math.min(announced, mostOfProject)
    const own = this.open.enter(`bytes ${id}`, bytes, most.bytes)
    const all = own && this.open.enter(`bytes of ${classId}`, bytes, most.bytesOfClass)
    const seconds = all ? this.bytes.secondsUntil(id) : 2
    if (own && all && seconds === 0) return () => (own(), all())
    own?.()
    all?.()
    throw new Refusal(429, 'tooMuchAtOnce', { seconds })
  }

  /** Counts the text of a project that a pupil has sent. @param bytes one a letter */
  sent(pupil: string, bytes: number): void {
    this.bytes.charge(pupil, bytes)
  }

  /** Counts a change of a pupil's hearts. @throws Refusal 429 if there were too many of late */
  heart(pupil: string): void {
    const seconds = this.hearts.take(pupil)
    if (seconds > 0) throw new Refusal(429, 'tooManyHearts', { seconds })
  }

  /** Counts a raised or lowered hand of a pupil. @throws Refusal 429 if there were too many of late */
  hand(pupil: string): void {
    const seconds = this.hands.take(pupil)
    if (seconds > 0) throw new Refusal(429, 'tooManyHands', { seconds })
  }
}
