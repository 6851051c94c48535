import type { Ask, Reply } from '#storage/ask.ts'

/** Waits; its argument is in seconds. */
export type Wait = (seconds: number) => Promise<void>

const sleep: Wait = (seconds) => new Promise((resolve) => setTimeout(resolve, seconds * 1000))

/** Seconds. A longer pause is shown to the child instead. */
const longestPause = 30
const mostPauses = 10

const secondsOf = (reply: Reply): number | null =>
  reply.kind === 'refused' && reply.status === 429 && reply.code === 'tooManyTries'
    ? (reply.facts.seconds ?? null)
    : null

interface Patience {
  /** Called when a pause begins. */
  readonly waits: () => void
  /** Whether the answer is still wanted after a pause. */
  readonly isWanted?: () => boolean
  readonly wait?: Wait | undefined
}

/** Asks the class again, after the pause that it names, where it answers that others have tried too often of late. */
export const patient =
  (ask: Ask, { waits, isWanted = () => true, wait = sleep }: Patience): Ask =>
  async (...request) => {
    let reply = await ask(...request)
    for (let pauses = 0; pauses < mostPauses; pauses++) {
      const seconds = secondsOf(reply)
      if (seconds === null || seconds > longestPause) break
      waits()
      await wait(seconds)
      if (!isWanted()) break
      reply = await ask(...request)
    }
    return reply
  }
