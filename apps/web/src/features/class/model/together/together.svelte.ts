import { diff, Peer, type Back, type Entry, type Shared } from '@botgarten/programs/together'
import { inScene, parseProject, sceneOf, type Project } from '@botgarten/programs'
import * as v from 'valibot'
import type { LabSession } from '#lab/session.svelte.ts'
import type { OwnSteps } from '#lab/undo.svelte.ts'
import { read, type Ask, type Reply } from '#storage/ask.ts'
import type { PupilLive } from '../live.svelte.ts'
import { pair as pairSchema, type Pair } from '../pupil.ts'
import { keep, kept } from './kept.ts'

const entries = v.array(v.custom<Entry>((one) => typeof one === 'object' && one !== null))
const state = v.object({ ...pairSchema.entries, length: v.number(), entries })
const beginning = v.object({ ...state.entries, project: v.unknown() })

const hand = v.object({
  at: v.nullable(v.string()),
  x: v.number(),
  y: v.number(),
  chosen: v.nullable(v.string()),
})
/** Over which block a hand is, at which share of its width and height, and which block it has chosen. */
export type OtherHand = v.InferOutput<typeof hand>

/** In ms: what a hand does within this is one step. */
const stepTime = 80
/** In ms: so often it is looked whether a held block was put down, and whether the class answers again. */
const again = 300
const retry = 1500
/** In ms: where no event came, the class is asked all the same. */
const look = 5000
const atOnce = 200

const sharedOf = ({ programs, brains, world }: Shared | Project): Shared => ({ programs, brains, world })
const same = (a: unknown, b: unknown) => a === b || JSON.stringify(a) === JSON.stringify(b)

/** Two on one program: this page's part of it. What is done here goes to the class, what comes from there is shown. */
export class Together implements OwnSteps {
  readonly pair: string
  readonly #live: PupilLive
  readonly #ask: Ask
  readonly #session: LabSession
  readonly #ended: () => void
  readonly #stops: (() => void)[]
  #peer: Peer | null = null
  #shown: Shared
  #isShowing = false
  #isBusy = false
  #noting: ReturnType<typeof setTimeout> | undefined
  #showing: ReturnType<typeof setTimeout> | undefined
  #done = $state.raw<readonly (readonly Back[])[]>([])
  #undone = $state.raw<readonly (readonly Back[])[]>([])
  #known = $state.raw<Pair | null>(null)
  /** The other one's hand. */
  hand = $state.raw<OtherHand | null>(null)
  /** The class cannot be reached. */
  isAway = $state(false)
  /** How much of what was done here the class has not got. */
  waiting = $state(0)
  /** There was more than a pair may do. */
  isFull = $state(false)

  /** @param opened the project as this page has opened it @param ended it is over, and the child knows */
  constructor(live: PupilLive, session: LabSession, pair: string, opened: Project, ended: () => void) {
    this.pair = pair
    this.#live = live
    this.#ask = live.ask
    this.#session = session
    this.#ended = ended
    this.#shown = sharedOf(opened)
    live.working = pair
    live.whenEvent = ({ event, data }) => this.#hear(event, data)
    const looking = setInterval(() => void this.#exchange(), look)
    session.shared = true
    session.undo.lend(this)
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
    const found = read(beginning, await this.#ask('GET', '/pair'))
    if (this.#live.working !== this.pair) return
    this.isAway = !found
    if (found?.id !== this.pair) return void (this.#showing = setTimeout(() => void this.#begin(), retry))
    this.#known = found
    const pending = kept()?.pending ?? []
    this.#peer = new Peer(found.me, sharedOf(parseProject(found.project)), pending)
    this.#peer.receive(0, found.entries)
    this.#note()
    await this.#exchange()
  }

  #hear(event: 'pair' | 'hand', data: unknown): void {
    if (event === 'pair') return void this.#exchange()
    const found = v.safeParse(hand, data)
    if (found.success) this.hand = found.output
  }

  #soon(): void {
    this.#noting ??= setTimeout(() => this.#note(), stepTime)
  }

  /** What was done here since the last time becomes operations. */
  #note(): void {
    clearTimeout(this.#noting)
    this.#noting = undefined
    if (!this.#peer) return
    const now = sharedOf(this.#session.project)
    const ops = diff(this.#shown, now)
    this.#shown = now
    if (ops.length === 0) return
    this.#done = [...this.#done, this.#peer.edit(ops)]
    this.#undone = []
    this.#made()
  }

  #made(): void {
    this.#keep()
    void this.#exchange()
  }

  #keep(): void {
    const own = kept()
    if (!own || own.pair !== this.pair || !this.#peer) return
    this.waiting = this.#peer.pending.length
    keep({ ...own, pending: [...this.#peer.pending] })
  }

  get canUndo() {
    return this.#done.length > 0
  }
  get canRedo() {
    return this.#undone.length > 0
  }
  undo(): void {
    this.#takeBack('undo')
  }
  redo(): void {
    this.#takeBack('redo')
  }

  #takeBack(way: 'undo' | 'redo'): void {
    this.#note()
    const [from, to] = way === 'undo' ? [this.#done, this.#undone] : [this.#undone, this.#done]
    const step = from.at(-1)
    if (!step || !this.#peer || !this.#session.settleBlocks()) return
    const back = this.#peer.undo(step)
    const left = from.slice(0, -1)
    const more = back.length > 0 ? [...to, back] : to
    ;[this.#done, this.#undone] = way === 'undo' ? [left, more] : [more, left]
    this.#show()
    this.#made()
  }

  /** Sends what is pending and fetches what is new, until there is neither. */
  async #exchange(): Promise<void> {
    if (this.#isBusy || !this.#peer || this.isFull) return
    this.#isBusy = true
    try {
      while (await this.#round(this.#peer));
    } finally {
      this.#isBusy = false
    }
    this.#show()
  }

  /** @returns whether there is more to do */
  async #round(peer: Peer): Promise<boolean> {
    const ops = peer.pending.slice(0, atOnce).map(({ n, base, op }) => ({ n, base, op }))
    if (ops.length > 0 && !this.#isTaken(await this.#ask('POST', '/pair/operations', { ops }))) return false
    const reply = await this.#ask('GET', `/pair?from=${peer.length}`)
    const found = read(state, reply)
    if (found?.id !== this.pair) return this.#isTaken(reply) && false
    this.isAway = false
    this.#known = found
    peer.receive(peer.length, found.entries)
    this.#keep()
    return peer.pending.length > 0 || peer.length < found.length
  }

  #isTaken(reply: Reply): boolean {
    if (reply.kind === 'done') return true
    this.isAway = reply.kind === 'away'
    if (reply.kind === 'refused' && reply.status !== 429 && reply.code !== 'noPair') this.isFull = true
    if (this.isAway || (reply.kind === 'refused' && reply.status === 429))
      setTimeout(() => void this.#exchange(), retry)
    return false
  }

  /** Shows what has come, once no block is in a hand. */
  #show(): void {
    clearTimeout(this.#showing)
    if (!this.#peer || this.#live.working !== this.pair) return
    if (!this.#session.settleBlocks()) {
      this.#showing = setTimeout(() => this.#show(), again)
      return
    }
    this.#note()
    this.#isShowing = true
    try {
      show(this.#session, this.#peer.shared)
    } finally {
      this.#isShowing = false
    }
    this.#shown = sharedOf(this.#session.project)
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
    await this.#exchange()
    keep(null)
    await this.#ask('DELETE', '/pair')
    this.#ended()
  }
}

/** Makes a project what the two have made of it; only what differs is touched. */
function show(session: LabSession, { programs, brains, world }: Shared): void {
  const before = session.lab.document
  if (!same(sceneOf(before.world), sceneOf(world)))
    session.apply({ kind: 'scene', after: sceneOf(world) }, 'silent')
  const ids = (of: Shared) => [
    Object.keys(of.programs).sort(),
    of.world.robots.map(({ id, program }) => [id, program]),
  ]
  const now = session.lab.document
  if (
    !same(ids(sharedOf(session.project)), ids({ programs, brains, world })) ||
    !same(now.world.robots, world.robots)
  )
    session.apply(
      { kind: 'robots', after: { ...now, programs, brains, world: inScene(world, sceneOf(now.world)) } },
      'silent',
    )
  for (const [program, after] of Object.entries(programs))
    if (!same(session.lab.document.programs[program], after))
      session.apply({ kind: 'program', program, after }, 'silent')
  for (const [id, after] of Object.entries(brains))
    if (!same(session.lab.document.brains[id], after)) session.apply({ kind: 'brain', id, after }, 'silent')
}
