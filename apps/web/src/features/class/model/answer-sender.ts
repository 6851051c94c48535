import {
  dropAnswer,
  secretChance,
  waitingAnswers,
  whenAnswerWaits,
  type WaitingAnswer,
} from '#storage/waiting-answers.ts'

/** Up to so long an answer waits by chance, so that its second says nothing of who gave it, ms. */
const longestWait = 120_000
/** The same once the form was closed: the class takes what is on its way for a minute. */
const shortWait = 20_000
const timeout = 30_000

/** What became of an answer. `closed`: it may be asked again · `never`: the class takes it under no circumstances. */
export type Sent = 'taken' | 'closed' | 'never' | 'away'
type Send = (answer: WaitingAnswer) => Promise<Sent>

/** Sends an answer without a cookie: the class does not know whose device it is. */
const send: Send = async (answer) => {
  try {
    const { ok, status } = await fetch('/api/class/answers', {
      ...{ method: 'POST', credentials: 'omit', body: JSON.stringify(answer) },
      ...{ headers: { 'content-type': 'application/json' }, signal: AbortSignal.timeout(timeout) },
    })
    if (ok) return 'taken'
    if (status === 409) return 'closed'
    // Also 429, from a busy address: it is sent again.
    return [400, 404, 413, 422].includes(status) ? 'never' : 'away'
  } catch {
    return 'away'
  }
}

/** Sends the answers that wait on this device, each at a time by chance. */
export class AnswerSender {
  readonly #send: Send
  readonly #timers = new Map<string, ReturnType<typeof setTimeout>>()
  /** Those whose form is closed wait until another one is asked. */
  readonly #refused = new Set<string>()

  constructor(sent: Send = send) {
    this.#send = sent
  }

  /** Begins with what waits from before. @returns how to stop */
  start(): () => void {
    this.#look()
    const stopListening = whenAnswerWaits(() => this.#look())
    return () => {
      stopListening()
      for (const timer of this.#timers.values()) clearTimeout(timer)
      this.#timers.clear()
    }
  }

  /** The class is asked a form now, or nothing any more: then all goes soon. */
  wake(asking: string | null): void {
    if (asking === null) for (const id of this.#timers.keys()) this.#in(shortWait, id)
    else this.#refused.clear()
    this.#look()
  }

  #look(): void {
    for (const { id } of waitingAnswers())
      if (!this.#timers.has(id) && !this.#refused.has(id)) this.#in(longestWait, id)
  }

  #in(longest: number, id: string): void {
    clearTimeout(this.#timers.get(id))
    this.#timers.set(
      id,
      setTimeout(() => void this.#try(id), secretChance() * longest),
    )
  }

  async #try(id: string): Promise<void> {
    const answer = waitingAnswers().find((one) => one.id === id)
    const sent = answer ? await this.#send(answer) : 'never'
    // Stopped meanwhile.
    if (!this.#timers.delete(id)) return
    if (sent === 'away') return this.#in(longestWait, id)
    if (sent === 'closed') this.#refused.add(id)
    else dropAnswer(id)
  }
}
