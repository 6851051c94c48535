import { Guesses, type Pace } from './joining/guesses.ts'
import { Refusal } from './refusal.ts'

/** Requests of one pupil that are answered at once, and how many more each second. A page sends about one a second. */
const [atOnce, eachSecond] = [300, 30]
/** Requests that an open stream counts as: each reads the whole state of its pupil. */
const ofStream = 20
/** Streams of one pupil on a node: a child has a device or two, and a stream that died unnoticed ends after minutes. */
const mostStreams = 8
/** Bytes of projects that one pupil sends at the same time: two of the largest. */
const mostBytes = 10_000_000
/** Pupils that are remembered before those without a debt are forgotten. */
const mostPupils = 10_000

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

interface Bucket {
  /** Requests that are left. */
  left: number
  /** When that was, in ms. */
  at: number
  streams: number
  bytes: number
}

/**
 * Bounds the load that one pupil can put on a node, so that the other classes on it stay as fast as before. Buckets refill by a
 * monotonic clock; each node has its own.
 */
export class Limits {
  private readonly buckets = new Map<string, Bucket>()
  private readonly elapsed: () => number
  /** Of everyone: codes, pictures and passwords that were wrong. */
  readonly guesses: GuessesOf

  /** @param elapsed ms of a clock that never goes back */
  constructor(elapsed: () => number) {
    this.elapsed = elapsed
    const pace = (of: keyof typeof wrongTries) => new Guesses(elapsed, wrongTries[of])
    this.guesses = {
      ...{ codes: pace('codes'), shortCodes: pace('shortCodes'), pictures: pace('pictures') },
      ...{ signIns: pace('signIns'), knownSignIns: pace('knownSignIns') },
    }
  }

  private bucketOf(pupil: string): Bucket {
    const at = this.elapsed()
    const found = this.buckets.get(pupil)
    if (!found) {
      if (this.buckets.size >= mostPupils) this.forget()
      const bucket = { left: atOnce, at, streams: 0, bytes: 0 }
      this.buckets.set(pupil, bucket)
      return bucket
    }
    found.left = Math.min(atOnce, found.left + ((at - found.at) / 1000) * eachSecond)
    found.at = at
    return found
  }

  /** How many pupils are remembered. */
  get size(): number {
    return this.buckets.size
  }

  private forget(): void {
    for (const [pupil, { at, streams, bytes }] of this.buckets)
      if (streams === 0 && bytes === 0 && this.elapsed() - at > (atOnce / eachSecond) * 1000)
        this.buckets.delete(pupil)
  }

  /** Counts a request of a pupil. @throws Refusal 429 if it has sent too many of late */
  request(pupil: string, cost = 1): void {
    const bucket = this.bucketOf(pupil)
    if (bucket.left < cost)
      throw new Refusal(429, 'tooFast', { seconds: Math.ceil((cost - bucket.left) / eachSecond) })
    bucket.left -= cost
  }

  /** Counts a stream of a pupil. @returns a function for its end @throws Refusal 429 if it has too many */
  stream(pupil: string): () => void {
    this.request(pupil, ofStream)
    const bucket = this.bucketOf(pupil)
    if (bucket.streams >= mostStreams) throw new Refusal(429, 'tooManyStreams', { seconds: 60 })
    bucket.streams += 1
    return () => void (bucket.streams -= 1)
  }

  /** Counts a project that a pupil sends. @returns a function for its end @throws Refusal 429 if too much is on its way */
  upload(pupil: string, bytes: number): () => void {
    const bucket = this.bucketOf(pupil)
    if (bucket.bytes > 0 && bucket.bytes + bytes > mostBytes)
      throw new Refusal(429, 'tooMuchAtOnce', { seconds: 2 })
    bucket.bytes += bytes
    return () => void (bucket.bytes -= bytes)
  }
}
