import type { Project } from '@botgarten/programs'
import { allowed } from '#lab/allowed.svelte.ts'
import type { Ask } from '#storage/ask.ts'
import type { Handout, Me } from './pupil.ts'
import { nowhere, type Report } from './report.ts'
import {
  holdWhileSeen,
  SharedStream,
  type Heard,
  type LiveEvent,
  type StreamListener,
} from './shared-stream.ts'

/** In ms: so often a page that is looked at reports. */
const reportEvery = 5000
/** In ms: so long after the last sign of the class, attention and the eye end by themselves. */
const longestSilence = 20_000
const tickEvery = 1000
/** Signed out, another pupil's, ended, or hidden. */
const notHere: readonly number[] = [401, 403, 410, 423]

/** What a page is at: its lab says so. */
export interface Work {
  /** Card or `free`. */
  readonly place: string
  report(): Report
  /** What is open, as it stands now, and its id on this device. */
  open?(): { readonly id: string; readonly project: Project }
  /** When the child changed something last, ms since 1970. */
  readonly changedAt: number
}

interface Listener {
  /** The class knows something else of this pupil. */
  me(me: Me): void
  /** The lesson is over for this pupil: who sits here is asked again. */
  over(): void
}

/** What the teacher does to this pupil's pages now, and what these tell the teacher. */
export class PupilLive {
  readonly ask: Ask
  readonly #listener: Listener
  readonly #makeStream: (hear: StreamListener) => SharedStream
  #heard = $state.raw<Heard | null>(null)
  /** The last sign of the class, and the time of now, ms since 1970. */
  #heardAt = $state(0)
  #now = $state(Date.now())
  #work = $state.raw<Work | null>(null)
  #isAway = false
  #stream: SharedStream | null = null
  #stops: (() => void)[] = []
  readonly #since = Date.now()

  constructor(ask: Ask, listener: Listener, makeStream = (hear: StreamListener) => new SharedStream(hear)) {
    this.ask = ask
    this.#listener = listener
    this.#makeStream = makeStream
  }

  get #isLost(): boolean {
    return this.#now - this.#heardAt > longestSilence
  }
  /** Does the teacher want to be looked at? It ends by itself after ten minutes, or when the class is not heard of. */
  get attention(): boolean {
    if (!this.#heard || this.#isLost) return false
    const { at, me } = this.#heard
    return me.attention !== null && this.#now < at + me.attention * 1000
  }
  /** Who looks at the work of this pupil now; no name: a substitute. */
  get inside(): { readonly by: string | null } | null {
    return this.#isLost ? null : (this.#heard?.me.inside ?? null)
  }
  get handouts(): readonly Handout[] {
    return this.#heard?.me.handouts ?? []
  }
  /** The questionnaire that the class is asked now, by its key; undefined until the class was heard of. */
  get asking(): string | null | undefined {
    return this.#heard?.me.asking
  }
  /** The classmate with whom this pupil works on one program, or who asks to. */
  get pair(): Me['pair'] {
    return this.#heard?.me.pair ?? null
  }
  /** The pair whose program is open on this page, by its id. */
  working = $state<string | null>(null)
  /** What is open on this page. */
  get opened(): { readonly id: string; readonly project: Project } | null {
    return this.#work?.open?.() ?? null
  }
  /** Hears what is sent once. */
  whenEvent: (event: LiveEvent) => void = () => {}
  /** What this pupil asks a classmate, and what classmates ask. */
  get asked(): Me['asked'] {
    return this.#heard?.me.asked ?? null
  }
  get questions(): Me['questions'] {
    return this.#heard?.me.questions ?? []
  }
  /** Card or `free` that is open here and that the teacher has not left open today; null: there is none. */
  get closedPlace(): string | null {
    const place = this.#work?.place
    return place !== undefined && !allowed.isOpen(place) ? place : null
  }

  /** Follows the class until `stop`. */
  start(): void {
    this.stop()
    const stream = this.#makeStream({
      state: (heard) => this.#take(heard),
      event: (event) => (event.event === 'gallery' ? allowed.seeGallery() : this.whenEvent(event)),
      end: () => this.#end(),
    })
    this.#stream = stream
    const report = setInterval(() => void this.#beat(), reportEvery)
    const tick = setInterval(() => (this.#now = Date.now()), tickEvery)
    this.#stops = [
      holdWhileSeen(stream),
      () => (clearInterval(report), clearInterval(tick)),
      () => stream.close(),
    ]
    void this.#beat()
  }

  stop(): void {
    for (const stop of this.#stops) stop()
    this.#stops = []
    this.#stream = null
  }

  /** A lab is open on this page. Returns how to leave it. */
  work(work: Work): () => void {
    this.#work = work
    void this.#beat()
    return () => {
      if (this.#work === work) this.#work = null
    }
  }

  #take(heard: Heard): void {
    const { me } = heard
    this.#heard = heard
    this.#now = Date.now()
    this.#heardAt = this.#now
    const { cards, level, gallery, asking, together } = me.class
    allowed.set({ cards, level, gallery, asking, together })
    this.#listener.me(me)
  }

  #end(): void {
    this.stop()
    this.#heard = null
    this.#listener.over()
  }

  async #beat(): Promise<void> {
    this.#stream?.beat()
    if (!this.#stream?.isHeld) return
    const changedAt = Math.max(this.#work?.changedAt ?? 0, this.#since)
    const idle = Math.floor((Date.now() - changedAt) / 1000)
    const reply = await this.ask('PUT', '/me/here', { ...(this.#work?.report() ?? nowhere), idle })
    if (reply.kind === 'refused' && notHere.includes(reply.status)) return this.#end()
    const isAway = reply.kind === 'away'
    // The cable was out: the stream may have died without a word.
    if (this.#isAway && !isAway) this.#stream?.reopen()
    else if (!isAway && this.#stream?.isOpen) this.#heardAt = Date.now()
    this.#isAway = isAway
  }

  /** @returns whether the class has it no more */
  async putAway(handout: string): Promise<boolean> {
    const reply = await this.ask('DELETE', `/me/handouts/${handout}`)
    const isGone = reply.kind === 'done' || (reply.kind === 'refused' && reply.code === 'noSuchHandout')
    if (isGone && this.#heard) {
      const { me, at } = this.#heard
      this.#heard = { me: { ...me, handouts: me.handouts.filter(({ id }) => id !== handout) }, at }
    }
    return isGone
  }
}
