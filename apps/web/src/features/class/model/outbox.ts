import { whenAnythingChanges } from '#storage/channel.ts'
import { sendAll, type Pause } from './sending.ts'
import type { Ask } from '#storage/ask.ts'

/** So long after a save it is sent, with all that came meanwhile, in milliseconds. */
const gap = 3000
/** After a failure it is tried again after 2 s, then twice as long each time. */
const [firstWait, longestWait] = [2000, 60_000]

/** These end by nothing that this page can do. */
const final: readonly Pause[] = ['signedOut', 'otherPupil', 'ended']

interface Report {
  /** What waits may have become another. `pause`: why nothing is sent now. */
  (pause: Pause | null): void
}

/** Sends what waits for the class: soon after a save, again and again after a failure, at once when the network is back. */
export class Outbox {
  readonly #ask: Ask
  readonly #report: Report
  readonly #confirm: () => Promise<Pause | null>
  #timer: ReturnType<typeof setTimeout> | undefined
  #failures = 0
  #pause: Pause | null = null
  #running: Promise<Pause | null> | null = null
  #again = false

  /** @param confirm compares the device with the class, once a page; returns the reason why that is not possible */
  constructor(ask: Ask, report: Report, confirm: () => Promise<Pause | null>) {
    this.#ask = ask
    this.#report = report
    this.#confirm = confirm
  }

  /** Begins to send, and listens for saves of all tabs. Returns how to stop. */
  start(): () => void {
    const stopListening = whenAnythingChanges(() => this.#changed())
    const now = () => void this.flush()
    const hidden = () => document.visibilityState === 'hidden' && now()
    addEventListener('online', now)
    addEventListener('pagehide', now)
    document.addEventListener('visibilitychange', hidden)
    now()
    return () => {
      stopListening()
      clearTimeout(this.#timer)
      this.#timer = undefined
      removeEventListener('online', now)
      removeEventListener('pagehide', now)
      document.removeEventListener('visibilitychange', hidden)
    }
  }

  #changed(): void {
    this.#report(this.#pause)
    // After a failure the next try stands already.
    if (this.#timer === undefined && !this.#isFinal) this.#in(gap)
  }

  get #isFinal(): boolean {
    return this.#pause !== null && final.includes(this.#pause)
  }

  #in(wait: number): void {
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => void this.flush(), wait)
  }

  /** Sends all that waits, now. @returns why something still waits */
  flush(): Promise<Pause | null> {
    clearTimeout(this.#timer)
    this.#timer = undefined
    if (this.#running) this.#again = true
    this.#running ??= this.#send().finally(() => (this.#running = null))
    return this.#running
  }

  async #send(): Promise<Pause | null> {
    do {
      this.#again = false
      this.#pause = await this.#tried()
      this.#report(this.#pause)
    } while (this.#again && this.#pause === null)
    this.#failures = this.#pause === null ? 0 : this.#failures + 1
    if (this.#pause !== null && !this.#isFinal) this.#in(waitAfter(this.#failures))
    return this.#pause
  }

  /** A device whose database refuses is tried again like a class that does. */
  async #tried(): Promise<Pause | null> {
    try {
      // Work that the class has lost is sent after that.
      return (await sendAll(this.#ask)) ?? (await this.#confirm()) ?? (await sendAll(this.#ask))
    } catch (cause) {
      console.warn('What waits for the class cannot be read.', cause)
      return 'trouble'
    }
  }
}

/** A class whose devices all come back at once does not ask in one moment. */
export const waitAfter = (failures: number, random = Math.random): number =>
  Math.min(longestWait, firstWait * 2 ** (failures - 1)) * (0.75 + random() / 2)
