import type { Bus, Ended, EndReason, Message } from './bus.ts'
import { EventStream } from './event-stream.ts'
import type { Here, Live } from './tiles.ts'

const minutes = 60_000
/** A stream is opened again after so long: whoever may not any more, gets none. */
const longestStream = 10 * minutes
const longestAttention = 10 * minutes
/** Attention goes on while a stream of a teacher is open, with room for a page that is loaded again. */
const lease = 20_000
const presenceKept = 4 * 60 * minutes

interface Stream {
  readonly class: string
  readonly pupil: string | null
  /** Null: of a substitute, or of a pupil. */
  readonly teacher: string | null
  readonly events: EventStream
  readonly openedAt: number
  /** What it shows, from the database. Null: who asks may not see it any more. */
  readonly read: () => Promise<object | null>
  dirty: boolean
  reading: boolean
}

type Opened = Pick<Stream, 'class' | 'pupil' | 'teacher' | 'read'> & {
  /** Called once, when the stream has ended. */
  readonly closed?: () => void
}

/** In ms of the clock that never goes back. */
interface Attention {
  readonly endsAt: number
  readonly leaseUntil: number
}

/**
 * What is live on this node: who is where, and the streams of pages. It forgets everything when it ends; the other nodes
 * and the next reports of pupils restore it.
 */
export class Hub {
  private readonly streams = new Set<Stream>()
  private readonly present = new Map<string, Map<string, Live>>()
  private readonly attention = new Map<string, Attention>()
  private readonly inside = new Map<string, { by: string | null; until: number }>()
  /** Reports that have not gone out yet: to the other nodes, and to the teachers of this one. */
  private outgoing = new Map<string, Map<string, Live>>()
  private heard = new Map<string, Map<string, Live>>()
  private readonly bus: Bus
  private readonly now: () => number
  private readonly elapsed: () => number

  /** @param clocks `now`: ms since 1970 · `elapsed`: ms of a clock that never goes back, for durations */
  constructor(bus: Bus, { now, elapsed }: { readonly now: () => number; readonly elapsed: () => number }) {
    this.bus = bus
    this.now = now
    this.elapsed = elapsed
    bus.listen(
      (message) => this.take(message),
      () => this.refreshAll(),
    )
  }

  private publish(message: Message) {
    this.take(message)
    this.bus.send(message)
  }

  private take(message: Message) {
    if (message.kind === 'tiles') for (const { id, live } of message.tiles) this.note(message.class, id, live)
    else if (message.kind === 'changed') this.refresh(message.class, message.pupils)
    else if (message.kind === 'attention') this.pay(message.class, message.left)
    else if (message.kind === 'inside') this.see(message.class, message.pupil, message)
    else if (message.kind === 'event') this.passOn(message)
    else this.endStreams(message)
  }

  // Who is where.

  report(classId: string, pupil: string, { idle, ...here }: Here): void {
    const seenAt = this.now()
    const live = { ...here, seenAt, changedAt: seenAt - idle * 1000 }
    this.note(classId, pupil, live)
    into(this.outgoing, classId).set(pupil, live)
  }

  private note(classId: string, pupil: string, live: Live) {
    // Clocks of nodes differ: the time of arrival counts.
    const shift = this.now() - live.seenAt
    const here = { ...live, seenAt: live.seenAt + shift, changedAt: live.changedAt + shift }
    into(this.present, classId).set(pupil, here)
    into(this.heard, classId).set(pupil, here)
  }

  liveOf(classId: string, pupil: string): Live | null {
    return this.present.get(classId)?.get(pupil) ?? null
  }

  // What pages get.

  /** Something in the database is another now, for these pupils or for all. */
  changed(classId: string, pupils: readonly string[] | null = null): void {
    this.publish({ kind: 'changed', class: classId, pupils })
  }

  private refresh(classId: string, pupils: readonly string[] | null) {
    for (const stream of this.streams)
      if (stream.class === classId && (stream.pupil === null || (pupils?.includes(stream.pupil) ?? true)))
        stream.dirty = true
  }

  private refreshAll() {
    for (const stream of this.streams) stream.dirty = true
  }

  /** Tells the pages of a pupil (null: of all) at once, unlike `changed`; what is lost is not sent again. */
  tell(classId: string, pupil: string | null, event: string, data: unknown): void {
    this.publish({ kind: 'event', class: classId, pupil, event, data })
  }

  private passOn({ class: classId, pupil, event, data }: Extract<Message, { kind: 'event' }>) {
    for (const stream of this.streams)
      if (stream.class === classId && stream.pupil !== null && stream.pupil === (pupil ?? stream.pupil))
        stream.events.send(event, data)
  }

  /** The class is over for these: their streams end, and what was live of them is forgotten. */
  end(classId: string | null, who: Ended, reason: EndReason): void {
    this.publish({ kind: 'end', class: classId, who, reason })
  }

  private endStreams({ class: classId, who, reason }: Extract<Message, { kind: 'end' }>) {
    for (const stream of this.streams) {
      if ((classId !== null && stream.class !== classId) || !concerns(who, stream)) continue
      stream.events.send('end', { reason })
      stream.events.close()
    }
    if (classId === null) return
    if (typeof who === 'object' && 'pupil' in who) this.present.get(classId)?.delete(who.pupil)
    if (who === 'pupils' || who === 'everybody') this.present.delete(classId)
    if (who !== 'substitutes') this.refresh(classId, [])
  }

  // Attention.

  /** @returns how long it lasts, s */
  askAttention(classId: string, on: boolean): number {
    this.publish({ kind: 'attention', class: classId, left: on ? longestAttention : 0 })
    return on ? longestAttention / 1000 : 0
  }

  private pay(classId: string, left: number) {
    const was = this.attentionOf(classId) !== null
    const now = this.elapsed()
    if (left > 0) this.attention.set(classId, { endsAt: now + left, leaseUntil: now + lease })
    else this.attention.delete(classId)
    if (was !== left > 0) this.refresh(classId, null)
  }

  /** Whole seconds for which attention is still asked at the most; null: it is not. */
  attentionOf(classId: string): number | null {
    const { endsAt = 0, leaseUntil = 0 } = this.attention.get(classId) ?? {}
    const now = this.elapsed()
    return Math.min(endsAt, leaseUntil) > now ? Math.ceil((endsAt - now) / 1000) : null
  }

  // Looking inside.

  /** @param by name of the teacher; null for a substitute @param seconds 0: no longer */
  look(classId: string, pupil: string, by: string | null, seconds: number): void {
    this.publish({ kind: 'inside', class: classId, pupil, by, left: seconds * 1000 })
  }

  private see(classId: string, pupil: string, { by, left }: { by: string | null; left: number }) {
    const was = this.insideOf(pupil) !== null
    if (left > 0) this.inside.set(pupil, { by, until: this.elapsed() + left })
    else this.inside.delete(pupil)
    if (was !== left > 0) this.refreshPupil(classId, pupil)
  }

  private refreshPupil(classId: string, pupil: string) {
    for (const stream of this.streams)
      if (stream.class === classId && stream.pupil === pupil) stream.dirty = true
  }

  insideOf(pupil: string): { readonly by: string | null } | null {
    const found = this.inside.get(pupil)
    return found && found.until > this.elapsed() ? { by: found.by } : null
  }

  // Streams.

  open({ closed, ...opened }: Opened): Response {
    const events = new EventStream(() => {
      this.streams.delete(stream)
      closed?.()
    })
    const stream: Stream = { ...opened, events, openedAt: this.elapsed(), dirty: true, reading: false }
    this.streams.add(stream)
    void this.show(stream)
    return events.response
  }

  private async show(stream: Stream) {
    if (stream.reading) return
    stream.reading = true
    stream.dirty = false
    try {
      const state = await stream.read()
      if (state) stream.events.send('state', state)
      else {
        stream.events.send('end', { reason: 'again' })
        stream.events.close()
      }
    } catch {
      // The database is busy: the next flush reads it again.
      stream.dirty = true
    } finally {
      stream.reading = false
    }
  }

  /** Sends what has come together since the last time; a few times a second. */
  async flush(): Promise<void> {
    for (const [classId, tiles] of this.outgoing)
      this.bus.send({ kind: 'tiles', class: classId, tiles: listed(tiles) })
    this.outgoing = new Map()
    const { heard } = this
    this.heard = new Map()
    for (const stream of this.streams) {
      const tiles = stream.pupil === null ? heard.get(stream.class) : undefined
      if (tiles) stream.events.send('tiles', { now: this.now(), tiles: listed(tiles) })
    }
    await Promise.all([...this.streams].filter(({ dirty }) => dirty).map((stream) => this.show(stream)))
  }

  /** Every few seconds: beats, leases of attention, looks inside that ended, streams that are old. */
  tick(): void {
    for (const stream of this.streams) {
      if (this.elapsed() - stream.openedAt < longestStream) stream.events.beat()
      else {
        stream.events.send('end', { reason: 'again' })
        stream.events.close()
      }
    }
    this.renewAttention()
    this.forget()
  }

  private renewAttention() {
    const taught = new Set([...this.streams].filter(({ pupil }) => pupil === null).map((one) => one.class))
    for (const [classId, { endsAt }] of this.attention) {
      if (this.attentionOf(classId) === null) {
        this.attention.delete(classId)
        this.refresh(classId, null)
      } else if (taught.has(classId))
        this.publish({ kind: 'attention', class: classId, left: endsAt - this.elapsed() })
    }
  }

  private forget() {
    for (const [pupil] of this.inside)
      if (this.insideOf(pupil) === null) {
        this.inside.delete(pupil)
        for (const stream of this.streams) if (stream.pupil === pupil) stream.dirty = true
      }
    for (const [classId, pupils] of this.present) {
      for (const [pupil, { seenAt }] of pupils) if (this.now() - seenAt > presenceKept) pupils.delete(pupil)
      if (pupils.size === 0) this.present.delete(classId)
    }
  }

  /** How many pages have a stream here. */
  get size(): number {
    return this.streams.size
  }

  async close(): Promise<void> {
    for (const stream of this.streams) stream.events.close()
    await this.bus.close()
  }
}

const concerns = (who: Ended, { pupil, teacher }: Stream): boolean =>
  who === 'everybody' ||
  (who === 'pupils' && pupil !== null) ||
  (who === 'substitutes' && pupil === null && teacher === null) ||
  (typeof who === 'object' && ('pupil' in who ? pupil === who.pupil : teacher === who.teacher))

function into<Value>(map: Map<string, Map<string, Value>>, key: string): Map<string, Value> {
  const found = map.get(key) ?? new Map<string, Value>()
  map.set(key, found)
  return found
}

const listed = (tiles: ReadonlyMap<string, Live>) => [...tiles].map(([id, live]) => ({ id, live }))
