import { deleteOwnDatabase, deleteSent } from '#storage/database.ts'
import { seenMark } from '#storage/class-versions.ts'
import { nextToThrow, whereabouts, type AllWhereabouts, type Whereabouts } from '#storage/outbox.ts'
import { account, setAccount, whenAccountChanges, type Account } from '#storage/account.ts'
import type { Picture } from '@botgarten/classroom/pictures'
import { compare, fetchWork } from './arriving.ts'
import { forgetHere, isProven, prove } from './here.ts'
import { refusedBy, type Refused } from './joining.svelte.ts'
import { PupilLive } from './live.svelte.ts'
import { Outbox } from './outbox.ts'
import { fetchMe, passage, type Me, type Passage } from './pupil.ts'
import type { Pause } from './sending.ts'
import { askAs, type Ask } from '#storage/ask.ts'

const noPlaces: AllWhereabouts = new Map()

/** The pupil of this page in its class: who it is, and where its work is. */
export class Member {
  readonly account: Account
  readonly ask: Ask
  readonly outbox: Outbox
  readonly live: PupilLive
  /** Is called when the lesson is over for this pupil. */
  whenOver: () => void = () => {}
  #places = $state.raw<AllWhereabouts>(noPlaces)
  #pause = $state.raw<Pause | null>(null)
  /** Whether this page has compared the device with the class. */
  #confirmed = $state(false)
  #handUp = $state(false)

  constructor(of: Account, ask: Ask = askAs(of.pupil)) {
    this.account = of
    this.ask = ask
    const report = (pause: Pause | null) => {
      this.#pause = pause
      void this.#look()
    }
    this.outbox = new Outbox(ask, report, async () => (this.#confirmed ? null : this.#compare()))
    this.live = new PupilLive(ask, { me: (me) => this.#take(me), over: () => this.whenOver() })
  }

  get handUp() {
    return this.#handUp
  }
  /** Why nothing is sent now. */
  get pause() {
    return this.#pause
  }
  /** How many projects are on this device alone, or not with all changes in the class. */
  get waiting(): number {
    return [...this.#places.values()].filter(({ kind }) => kind !== 'class').length
  }
  /** Whether nothing is left here that the class has not confirmed to have since this page was opened. */
  get allConfirmed(): boolean {
    return this.#confirmed && this.waiting === 0
  }
  /** Where a project is. Until the class has confirmed that it has it, it waits. */
  placeOf(project: string): Whereabouts | undefined {
    const place = this.#places.get(project)
    return place?.kind === 'class' && !this.#confirmed ? { kind: 'waiting' } : place
  }

  async #look(): Promise<void> {
    this.#places = await whereabouts()
  }

  /** Begins to send what waits. Returns how to stop. */
  start(): () => void {
    const stop = this.outbox.start()
    // Another child uses this device now: what is open here is not theirs.
    const stopWatching = whenAccountChanges(() => location.assign('/'))
    return () => (stop(), stopWatching(), this.live.stop())
  }

  /** Fetches the pupil's work from the class onto this device. */
  async fetchWork(only?: string): Promise<Pause | null> {
    const pause = await fetchWork(this.ask, only)
    await this.#noteCompared(pause)
    return pause
  }

  /** Compares the device with the class. @returns the reason why that is not possible */
  async #compare(): Promise<Pause | null> {
    const list = await compare(this.ask)
    const pause = typeof list === 'string' ? list : null
    await this.#noteCompared(pause)
    return pause
  }

  async #noteCompared(pause: Pause | null): Promise<void> {
    if (pause === null) this.#confirmed = true
    await this.#look()
  }

  /**
   * Sends waiting work and compares again: the class may have been restored since the last comparison, and this device may
   * have the only copy.
   */
  async confirm(): Promise<void> {
    this.#confirmed = false
    await this.outbox.flush()
    await this.#look()
  }

  /** The class shows a mark that this device has not seen: another device has saved, or the class was restored. */
  async #lookAtMark(mark: string | null | undefined): Promise<void> {
    if (mark === undefined || mark === (await seenMark())) return
    await this.fetchWork()
    if (this.waiting > 0) void this.outbox.flush()
  }

  /** The child has answered yes: whether that is enough. */
  async enter(): Promise<Passage> {
    const me = await fetchMe(this.ask)
    if (typeof me === 'object') this.#take(me)
    return passage(me, isProven(this.account.pupil))
  }

  #take(me: Me): void {
    this.#handUp = me.hand
    void this.#lookAtMark(me.mark)
    const { nickname, class: of } = me
    // The teacher may have given it another name.
    if (nickname !== this.account.nickname || of.name !== this.account.className)
      setAccount({ ...this.account, nickname, className: of.name })
  }

  /** The child shows the three pictures once more. @returns why they were not taken */
  async showPictures(pictures: readonly Picture[]): Promise<Refused | null> {
    const reply = await this.ask('POST', '/me/pictures', { pictures })
    if (reply.kind !== 'done') return refusedBy(reply)
    prove(this.account.pupil)
    return null
  }

  /** @returns null if the class knows; `often`: too many moves of late */
  async raiseHand(up: boolean): Promise<'away' | 'often' | null> {
    const reply = await this.ask('PUT', '/me/hand', { up })
    if (reply.kind === 'refused' && reply.code === 'tooManyHands') return 'often'
    if (reply.kind !== 'done') return 'away'
    this.#handUp = up
    return null
  }

  /** The device is nobody's from now on. What is in the class goes from here; what is not waits, and nobody else sees it. */
  async leave(): Promise<void> {
    this.live.stop()
    await this.confirm()
    await this.ask('POST', '/me/leave')
    if (this.allConfirmed && (await nextToThrow()) === null) await deleteSent()
    this.forget()
  }

  /** The class has ended: its copies go from this device. */
  async end(): Promise<void> {
    await deleteOwnDatabase()
    this.forget()
  }

  forget(): void {
    forgetHere()
    setAccount(null)
  }
}

let member: Member | null = null

/** The one member of this page; null where the device is nobody's. */
export function memberHere(): Member | null {
  const of = account()
  if (of) member ??= new Member(of)
  return member
}
