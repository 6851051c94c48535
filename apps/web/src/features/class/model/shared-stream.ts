// One stream a browser: HTTP/1.1 allows six connections. The page that was used last holds it, the others hear from that one.
import { ownName } from '#storage/account.ts'
import { freshId } from '#storage/projects.ts'
import { LiveStream } from '#parts/page/live-stream.ts'
import type { Source } from '#parts/page/source.ts'
import * as v from 'valibot'
import { me, type Me } from './pupil.ts'

/** A state of the class for this pupil. `at`: when it arrived, ms since 1970. */
export interface Heard {
  readonly me: Me
  readonly at: number
}

const events = ['pair', 'hand', 'gallery'] as const

/** Something short that is not sent again. */
export interface LiveEvent {
  readonly event: (typeof events)[number]
  readonly data: unknown
}

type Message =
  | { readonly kind: 'holds'; readonly since: number; readonly page: string }
  | ({ readonly kind: 'state' } & Heard)
  | ({ readonly kind: 'event' } & LiveEvent)
  | { readonly kind: 'end'; readonly reason: string }
  /** The page is not looked at any more: another one takes the stream. */
  | { readonly kind: 'free' }

export interface StreamListener {
  state(heard: Heard): void
  event?(event: LiveEvent): void
  /** The class is over for this pupil, or for now. */
  end(reason: string): void
}

/** What pages tell each other through. */
export type Channel = Pick<BroadcastChannel, 'postMessage' | 'close' | 'onmessage'>

/** In ms: a page that holds the stream and has sent no sign of life for this long has lost it. */
const silence = 15_000

const ending = v.object({ reason: v.string() })
const isVisible = () => typeof document === 'undefined' || document.visibilityState === 'visible'

/** Holds the stream of this browser, or listens to the page that does. */
export class SharedStream {
  readonly #stream: LiveStream
  readonly #hear: StreamListener
  readonly #channel: Channel
  /** Pages over plain http have no `crypto.randomUUID`. */
  readonly #page = freshId('page')
  /** Since when this page holds the stream, ms; 0: another one does. */
  #since = 0
  #heardAt = Date.now()
  #last: Heard | null = null

  constructor(
    hear: StreamListener,
    open: () => Source = () => new EventSource('/api/class/me/stream'),
    channel: Channel = new BroadcastChannel(ownName('botgarten-live')),
  ) {
    this.#hear = hear
    this.#stream = new LiveStream(open, (source) => this.#follow(source))
    this.#channel = channel
    channel.onmessage = ({ data }: MessageEvent<Message>) => this.#listen(data)
  }

  /** Does this page hold the stream, and does it stand? */
  get isOpen(): boolean {
    return this.#stream.isOpen
  }
  get isHeld(): boolean {
    return this.#since > 0
  }

  /** Takes the stream, from whichever page has it. */
  take(): void {
    if (this.isHeld) return
    this.#since = Date.now()
    this.#channel.postMessage({ kind: 'holds', since: this.#since, page: this.#page } satisfies Message)
    this.reopen()
  }

  /** Opens the stream again where this page holds it: the old one may be dead without a word. */
  reopen(): void {
    if (this.isHeld) this.#stream.open()
  }

  #follow(source: Source): void {
    source.addEventListener('state', ({ data }) => this.#takeIn(data))
    for (const event of events)
      source.addEventListener(event, ({ data }) => this.#passOn({ event, data: JSON.parse(data) as unknown }))
    source.addEventListener('end', ({ data }) => this.#ends(v.parse(ending, JSON.parse(data)).reason))
  }

  /** Lets go of it: another page that is looked at takes it. */
  release(): void {
    if (!this.isHeld) return
    this.#letGo()
    this.#channel.postMessage({ kind: 'free' } satisfies Message)
  }

  /** Tells the other pages that the stream stands; takes it where nobody has told so for long. Once every few seconds. */
  beat(): void {
    if (this.isHeld && this.isOpen && this.#last)
      this.#channel.postMessage({ kind: 'state', ...this.#last } satisfies Message)
    if (!this.isHeld && isVisible() && Date.now() - this.#heardAt > silence) this.take()
  }

  close(): void {
    this.release()
    this.#channel.close()
  }

  #letGo(): void {
    this.#stream.close()
    this.#since = 0
    this.#heardAt = Date.now()
  }

  #passOn(event: LiveEvent): void {
    this.#channel.postMessage({ kind: 'event', ...event } satisfies Message)
    this.#hear.event?.(event)
  }

  #takeIn(text: string): void {
    const heard = { me: v.parse(me, JSON.parse(text)), at: Date.now() }
    this.#last = heard
    this.#channel.postMessage({ kind: 'state', ...heard } satisfies Message)
    this.#hear.state(heard)
  }

  #ends(reason: string): void {
    if (reason === 'again') return this.reopen()
    this.#channel.postMessage({ kind: 'end', reason } satisfies Message)
    this.#letGo()
    this.#hear.end(reason)
  }

  #listen(message: Message): void {
    this.#heardAt = Date.now()
    if (message.kind === 'holds') this.#yields(message)
    else if (message.kind === 'free') void (isVisible() && this.take())
    else if (message.kind === 'end') this.#hear.end(message.reason)
    else if (message.kind === 'event') this.#hear.event?.(message)
    else this.#hear.state(message)
  }

  /** Of two pages that take it in one moment the later one has it. */
  #yields({ since, page }: Extract<Message, { kind: 'holds' }>): void {
    if (since < this.#since || (since === this.#since && page < this.#page)) return
    this.#letGo()
  }
}

/** Holds the stream while the page is looked at. Returns how to stop. */
export function holdWhileSeen(stream: SharedStream): () => void {
  const look = () => (isVisible() ? stream.take() : stream.release())
  const leave = () => stream.release()
  for (const event of ['focus', 'pageshow']) addEventListener(event, look)
  addEventListener('pagehide', leave)
  document.addEventListener('visibilitychange', look)
  look()
  return () => {
    for (const event of ['focus', 'pageshow']) removeEventListener(event, look)
    removeEventListener('pagehide', leave)
    document.removeEventListener('visibilitychange', look)
  }
}
