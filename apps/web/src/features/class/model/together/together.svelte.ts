import { diff, Peer, resumed, type Back, type Shared } from '@botgarten/programs/together'
import { parseProject } from '@botgarten/programs'
import type { Floor } from '@botgarten/simulation'
import * as v from 'valibot'
import { robotName } from '#figures/robot-names.ts'
import { floorToRun, type Packs } from '#lab/opening.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import type { Ask, Reply } from '#storage/ask.ts'
import type { PupilLive } from '../live.svelte.ts'
import type { Pair } from '../pupil.ts'
import type { LiveEvent } from '../shared-stream.ts'
import { keep, kept, type Kept } from './kept.ts'
import { otherHand, type OtherHand } from './other-hand.ts'
import { fetchBeginning, fetchFrom, type Beginning } from './order.ts'
import { StepsOfOne } from './own-steps.svelte.ts'
import { hasOtherFloor, isOnPhoto, sharedOf, show, waitingIn } from './show.ts'

/** In ms: what a hand does within this is one step. */
const stepTime = 80
/** In ms: so often it is looked whether a held block was put down, and whether the class answers again. */
const again = 300
const retry = 1500
/** In ms: where no event came, the class is asked all the same. */
const look = 5000
const atOnce = 200
/** The class takes no more of it: it is full, or this is too large. */
const tooMuch: readonly number[] = [400, 409, 413]
/** So many steps of what was shown are remembered: the device may have saved an earlier one last. */
const mostShown = 12

/** Two on one program: this page's part of it. What is done here goes to the class, what comes from there is shown. */
export class Together {
  readonly pair: string
  readonly #live: PupilLive
  readonly #ask: Ask
  readonly #session: LabSession
  readonly #packs: Packs
  readonly #ended: () => void
  readonly #stops: (() => void)[]
  #peer: Peer | null = null
  #shown: Shared
  #isShowing = false
  #busy: Promise<void> | null = null
  #isAsked = false
  /** Blocks or a picture that have not come yet are missing for what was heard. */
  #isBringing = false
  #floor: { readonly world: Shared['world']; readonly painted: Floor } | null = null
  #noting: ReturnType<typeof setTimeout> | undefined
  #showing: ReturnType<typeof setTimeout> | undefined
  readonly #steps = new StepsOfOne({
    settle: () => this.note(),
    takeBack: (step) => this.#takeBack(step),
  })
  #known = $state.raw<Pair | null>(null)
  /** The other one's hand. */
  hand = $state.raw<OtherHand | null>(null)
  /** The class cannot be reached. */
  isAway = $state(false)
  /** There was more than a pair may do. */
  isFull = $state(false)
  /** What the other one did is not shown while this page's Bo drives, or a moment of the past is looked at. */
  waits = $state(false)
  /** An own photo was put in: it goes to no other child, and is out again. */
  hadPhoto = $state(false)

  /** @param packs bring blocks that the other one has used @param ended it is over, and the child knows */
  constructor(live: PupilLive, session: LabSession, pair: string, packs: Packs, ended: () => void) {
    this.pair = pair
    this.#packs = packs
    this.#live = live
    this.#ask = live.ask
    this.#session = session
    this.#ended = ended
    this.#shown = sharedOf(session.project)
    live.working = pair
    live.whenEvent = (event) => this.#hear(event)
    const looking = setInterval(() => void this.#exchange(), look)
    session.shared = true
    session.undo.lend(this.#steps)
    this.#stops = [
      session.listen(({ kind }) => kind === 'changed' && !this.#isShowing && this.#soon()),
      () => clearInterval(looking),
    ]
    void this.#begin()
  }

  /** What the class says of the pair now. */
  get about(): Pair | null {
    const now = this.#live.pair
    return now?.id === this.pair ? now : this.#known
  }
  /** The other one has left, or the class has ended it. */
  get isOver(): boolean {
    const now = this.#live.pair
    return this.isFull || now === null || now.id !== this.pair || now.over
  }

  stop(): void {
    for (const stop of this.#stops) stop()
    clearTimeout(this.#noting)
    clearTimeout(this.#showing)
    this.#session.undo.lend(null)
    this.#session.shared = false
    this.#live.whenEvent = () => {}
    if (this.#live.working === this.pair) this.#live.working = null
  }

  async #begin(): Promise<void> {
    const found = await fetchBeginning(this.#ask, this.pair)
    if (this.#live.working !== this.pair) return
    this.isAway = !found
    if (!found) return void (this.#showing = setTimeout(() => void this.#begin(), retry))
    this.#takeUp(found)
    await this.#exchange()
  }

  /** Nothing is lost of what was done here before the class was heard of. */
  #takeUp(found: Beginning): void {
    const { me: author, entries, project } = found
    this.#known = found
    const own = kept()
    const { pending, shown } = own?.pair === this.pair ? own : { pending: [], shown: [0] }
    const shared = sharedOf(parseProject(project))
    const opened = sharedOf(this.#session.opened.project)
    this.#shown = sharedOf(this.#session.project)
    const made = resumed({ author, shared, entries, pending, shown }, opened, this.#shown)
    this.#peer = new Peer(author, shared, made)
    this.#isBringing = true
    this.#peer.receive(0, entries)
    this.#keep()
  }

  #hear({ event, data }: LiveEvent): void {
    if (event === 'pair') return void this.#exchange()
    const found = v.safeParse(otherHand, data)
    if (found.success) this.hand = found.output
  }

  #soon(): void {
    this.#noting ??= setTimeout(() => this.note(), stepTime)
  }

  /** What was done here since the last time becomes operations, which this browser keeps at once. */
  note(): void {
    clearTimeout(this.#noting)
    this.#noting = undefined
    if (!this.#peer) return
    const now = sharedOf(this.#session.project)
    const ops = diff(this.#shown, now)
    this.#shown = now
    if (ops.length === 0) return
    this.#steps.did(this.#peer.edit(ops))
    this.hadPhoto = isOnPhoto(now) && !isOnPhoto(this.#peer.shared)
    this.#made()
  }

  #made(): void {
    this.#keep()
    void this.#exchange()
  }

  #keep(more: Partial<Kept> = {}): void {
    const own = kept()
    if (!own || own.pair !== this.pair || !this.#peer) return
    keep({ ...own, pending: [...this.#peer.pending], ...more })
  }

  /** So much of the common order is seen here now. */
  #keepShown({ length }: Peer): void {
    const shown = kept()?.shown ?? []
    if (shown.at(-1) !== length) this.#keep({ shown: [...shown, length].slice(-mostShown) })
  }

  #takeBack(step: readonly Back[]): readonly Back[] | null {
    if (!this.#peer || !this.#session.settleBlocks()) return null
    const back = this.#peer.undo(step)
    this.#show(true)
    this.#made()
    return back
  }

  /** Sends what is pending and fetches what is new, until there is neither. */
  #exchange(): Promise<void> {
    this.#isAsked = this.#busy !== null
    this.#busy ??= this.#rounds().finally(() => {
      this.#busy = null
      this.#show()
      // Meanwhile there was more.
      if (this.#isAsked && !this.isAway) void this.#exchange()
    })
    return this.#busy
  }

  async #rounds(): Promise<void> {
    if (!this.#peer || this.isFull) return
    while (await this.#round(this.#peer));
    await this.#bring(this.#peer.shared)
  }

  /** What the other one has used may be new to this page: more blocks, another floor. */
  async #bring(shared: Shared): Promise<void> {
    try {
      const { project } = this.#session
      if (!hasOtherFloor(this.#session, shared)) await this.#packs.loadFor(shared)
      else if (this.#floor?.world !== shared.world)
        this.#floor = {
          world: shared.world,
          painted: await floorToRun({ ...project, ...shared }, this.#packs),
        }
    } catch (cause) {
      console.warn('What the other one has used has not come.', cause)
    } finally {
      this.#isBringing = false
    }
  }

  /** @returns whether there is more to do */
  async #round(peer: Peer): Promise<boolean> {
    const ops = peer.pending.slice(0, atOnce).map(({ n, base, op }) => ({ n, base, op }))
    if (ops.length > 0 && !this.#isTaken(await this.#ask('POST', '/pair/operations', { ops }))) return false
    const { reply, found } = await fetchFrom(this.#ask, this.pair, peer.length)
    if (!found) return this.#isTaken(reply) && false
    this.isAway = false
    this.#known = found
    this.#isBringing ||= found.entries.length > 0
    peer.receive(peer.length, found.entries)
    this.#keep()
    return peer.pending.length > 0 || peer.length < found.length
  }

  #isTaken(reply: Reply): boolean {
    if (reply.kind === 'done') return true
    this.isAway = reply.kind === 'away'
    if (reply.kind === 'refused' && tooMuch.includes(reply.status)) this.isFull = true
    if (this.isAway || (reply.kind === 'refused' && reply.status === 429))
      setTimeout(() => void this.#exchange(), retry)
    return false
  }

  /** Shows what has come, once no block is in a hand. @param all a hand wants to see it at once */
  #show(all = false): void {
    if (!this.#peer || this.#isBringing || this.#live.working !== this.pair) return
    clearTimeout(this.#showing)
    if (!this.#session.settleBlocks()) {
      this.#showing = setTimeout(() => this.#show(), again)
      return
    }
    this.note()
    this.#keepShown(this.#peer)
    const { shared } = this.#peer
    const floor = this.#floor?.world === shared.world ? this.#floor.painted : null
    this.#isShowing = true
    try {
      this.waits = show(this.#session, shared, all ? null : waitingIn(this.#session), floor)
    } finally {
      this.#isShowing = false
    }
    this.#shown = sharedOf(this.#session.project)
    if (this.waits) this.#waitForRun()
  }

  #waitForRun(): void {
    this.#showing = setTimeout(
      () => (waitingIn(this.#session) === null ? this.#show() : this.#waitForRun()),
      again,
    )
  }

  /** The robot whose program the other one edits, by its place among all; null: the one that is seen here, or no hand. */
  get elsewhere(): number | null {
    const { hand } = this
    const { robots } = this.#session.lab.document.world
    if (hand?.program == null || hand.program === this.program) return null
    const at = robots.findIndex(({ program }) => program === hand.program)
    return at < 0 ? null : at
  }

  /** What that robot is called; empty: there is none. */
  get robotElsewhere(): string {
    return this.elsewhere === null ? '' : robotName(this.elsewhere)
  }
  /** The program that is seen here. */
  get program(): string {
    return this.#session.robot.program
  }

  /** Tells the other one where this hand is. */
  point(here: OtherHand): void {
    if (this.#peer && !this.isAway && !this.isOver) void this.#ask('PUT', '/pair/hand', here)
  }

  /** Who was the hand is the eye. */
  swap(): void {
    const role = this.about?.role === 'hand' ? 'eye' : 'hand'
    void this.#ask('PUT', '/pair/role', { role })
  }

  /** Each goes on with a copy of its own. */
  async leave(): Promise<void> {
    this.note()
    await this.#exchange()
    await this.#busy
    keep(null)
    await this.#ask('DELETE', '/pair')
    this.#ended()
  }
}
