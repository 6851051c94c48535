import { untrack } from 'svelte'
import {
  starsOf,
  visited,
  policy,
  type BestWay,
  type Course,
  type Episode,
  type QTrace,
} from '@botgarten/learning/q-learning'
import { courseOf, drawWay, learningKey, readMap, sectionsOf, type MapFile } from '@botgarten/materials/maps'
import { learningIn, type Learned, type LearnedRun, type LearningOutline } from '@botgarten/programs'
import type { Desk } from '#lib/state/desk.svelte.ts'
import type { Session } from '#lib/state/session.svelte.ts'
import { Floors } from '#lib/world/building/floors.ts'
import { MOVE } from './phases.ts'
import { takeApart, type Picture } from './picture.ts'
import { roadsOf, type Road } from './roads.ts'

/** `over`: a limit stopped it · `stopped`: a hand did. */
export type State = 'ready' | 'playing' | 'paused' | 'over' | 'stopped'

/** A map that has been brought. */
export interface Stage {
  readonly id: string
  readonly map: MapFile
  readonly picture: Picture
  readonly roads: readonly Road[]
}

/** What the screen shows of a course at the move that is shown. Made anew for every move, never written to. */
export interface Shown {
  readonly t: number
  readonly made: number
  /** Counted from 1: the one that is on. */
  readonly episode: number
  readonly trace: QTrace | null
  readonly q: Float64Array
  readonly tries: Uint32Array
  readonly visited: readonly boolean[]
  /** By station the best move; −1: none. */
  readonly policy: readonly number[]
  readonly way: BestWay
  readonly found: number | null
  readonly over: Course['over']
  /** 0..5 of the move that was made: before and after. */
  readonly stars: { readonly before: number; readonly after: number }
}

/** Fields and closed roads are blocks: who holds the blocks changes them. */
export interface Blocks {
  setField(block: string, field: string, value: string): void
  setClosed(map: string, roads: LearningOutline['closed']): void
}

const addresses = import.meta.glob<string>(
  '../../../../../../content/maps/{city,forest,mars,railway}/map.svg',
  {
    query: '?url&no-inline',
    import: 'default',
    eager: true,
  },
)

/** Milliseconds of a frame that learning may take in turbo: the rest is for drawing. */
const BUDGET = 7
const SLICE = 400
/** The state is kept on the device so often while it plays. */
const KEEP_EVERY = 2000
const MOST_RUNS = 200
/** So many runs are drawn over each other. */
const OVERLAID = 5

/** One playground: a course of learning, its map, and the verbs of a child's hand. */
export class Learning {
  readonly session: Session
  readonly #desk: Desk
  readonly #blocks: Blocks
  readonly #floors = new Floors()
  outline = $derived.by(() => learningIn(this.session.program))
  #key = $derived(this.outline ? learningKey(this.outline) : '')
  #stage = $state.raw<Stage | null>(null)
  #course: Course | null = null
  #shown = $state.raw<Shown | null>(null)
  #state = $state<State>('ready')
  #progress = $state(1)
  #runs = $state.raw<readonly LearnedRun[]>([])
  #curves = $state.raw<readonly (readonly Episode[])[]>([])
  /** 1, 2, 3; Infinity: turbo. */
  speed = $state(1)
  guess = $state('')
  #seed = 1
  #frame = 0
  #before = 0
  #keptAt = 0
  /** Has this run been written into the table? */
  #noted = false
  /** One step: the move that is on is the last. */
  #single = false

  constructor(session: Session, desk: Desk, blocks: Blocks) {
    this.session = session
    this.#desk = desk
    this.#blocks = blocks
    const kept = session.learned
    this.#runs = kept?.runs ?? []
    this.#seed = kept?.seed ?? 1
    session.learnFirst = () => this.#learnFirst()
  }

  get stage() {
    return this.#stage
  }
  get shown() {
    return this.#shown
  }
  get state() {
    return this.#state
  }
  /** 0..1 of the move that is shown. */
  get progress() {
    return this.#progress
  }
  get runs() {
    return this.#runs
  }
  /** Episodes of the last runs, the newest first. */
  get curves() {
    return this.#curves
  }
  get seed() {
    return this.#seed
  }
  get world() {
    return this.#course?.learner.world ?? null
  }
  /** Sections of the shortest way; null: there is none. */
  get shortest() {
    return this.#course && sectionsOf(this.#course)
  }

  /** Begins to follow the blocks and to listen to the page. Returns how to end it. */
  open(): () => void {
    const stop = $effect.root(() => {
      $effect(() => {
        const key = this.#key
        untrack(() => void this.#follow(key))
      })
    })
    const away = () => document.hidden && this.pause()
    const escape = (event: KeyboardEvent) =>
      event.key === 'Escape' && this.#state === 'playing' && this.pause()
    document.addEventListener('visibilitychange', away)
    window.addEventListener('keydown', escape)
    return () => {
      stop()
      document.removeEventListener('visibilitychange', away)
      window.removeEventListener('keydown', escape)
      this.pause()
      this.session.learnFirst = () => this.session.learns
    }
  }

  /** The blocks say something else: a new course on the map they name, or the one that was kept. */
  async #follow(key: string): Promise<void> {
    this.#halt('ready')
    const { outline } = this
    if (!outline) return
    const stage = await this.#bring(outline.map)
    if (key !== this.#key) return
    this.#stage = stage
    if (!stage || !this.#create()) return
    const kept = this.session.learned
    if (kept?.key === key && kept.moves > 0) await this.#goOn(kept, key)
  }

  async #bring(id: string): Promise<Stage | null> {
    if (this.#stage?.id === id) return this.#stage
    const address = addresses[`../../../../../../content/maps/${id}/map.svg`]
    if (address === undefined) return null
    const text = await (await fetch(address)).text()
    const { map } = readMap(text)
    return map && { id, map, picture: takeApart(text), roads: roadsOf(map) }
  }

  #create(): boolean {
    const { outline } = this
    this.#course = null
    this.#shown = null
    this.#noted = false
    if (!outline || !this.#stage) return false
    try {
      this.#course = courseOf(outline, this.#stage.map, this.#seed)
    } catch (cause) {
      // A station that this map does not have: the block says so.
      if (!(cause instanceof RangeError)) throw cause
      return false
    }
    this.#show(1)
    return true
  }

  /** Learns again what was learned when the page was left: the same seed gives the same (running.md 2). */
  async #goOn(kept: Learned, key: string): Promise<void> {
    const course = this.#course!
    while (course.made < kept.moves && !course.over) {
      course.advance(Math.min(20_000, kept.moves - course.made))
      await new Promise(requestAnimationFrame)
      if (key !== this.#key || course !== this.#course) return
    }
    this.#noted = kept.noted
    this.#show(1)
    this.#curves = [course.episodes]
    this.#state = course.over ? 'over' : 'paused'
  }

  #show(progress: number): void {
    const course = this.#course
    if (!course) return
    const { learner, trace } = course
    const q = learner.q.slice()
    const stars = {
      before: trace ? starsOf(learner, trace.before) : 0,
      after: trace ? starsOf(learner, trace.after) : 0,
    }
    this.#progress = progress
    this.#shown = {
      ...{ t: course.shown, made: course.made, trace, q, stars, over: course.over },
      episode: trace?.episode ?? learner.episodes + 1,
      tries: learner.tries.slice(),
      visited: visited(learner),
      policy: policy(learner),
      way: course.way(),
      found: course.foundIn(),
    }
  }

  // ---- the bar ----

  play(): void {
    if (!this.#course || this.#state === 'playing') return
    if (this.#state === 'over' || this.#state === 'stopped') this.#renew(this.#seed + 1)
    this.session.lab.stop()
    this.#state = 'playing'
    this.#single = false
    this.#run()
  }

  pause(): void {
    if (this.#state === 'playing') this.#halt('paused')
  }

  /** Ends this learning; what was learned stays. */
  stop(): void {
    if (!this.#course || this.#state === 'ready') return
    this.#halt('stopped')
    this.#finish()
  }

  /** One move, from where it is shown. */
  step(): void {
    if (!this.#course || this.#state === 'over' || this.#state === 'stopped') return
    this.#single = true
    if (this.#state === 'playing') return
    if (!this.#course.next()) return this.#end()
    this.session.lab.stop()
    this.#show(0)
    this.#state = 'playing'
    this.#run()
  }

  /** From the beginning, with equal dice. */
  again(): void {
    this.#halt('ready')
    this.#renew(this.#seed)
  }

  goTo(move: number): void {
    if (!this.#course) return
    if (this.#state !== 'ready') this.#halt('paused')
    this.#course.goTo(move)
    this.#show(1)
    if (this.#course.over) this.#state = this.#state === 'ready' ? 'ready' : 'over'
  }

  #renew(seed: number): void {
    this.#seed = seed
    this.#create()
    this.#keep()
  }

  #halt(state: State): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
    const was = this.#state
    this.#state = state
    if (was === 'playing') {
      this.#show(1)
      this.#keep()
    }
  }

  #run(): void {
    this.#before = performance.now()
    if (this.#frame === 0) this.#frame = requestAnimationFrame(this.#turn)
  }

  #turn = (now: number): void => {
    this.#frame = requestAnimationFrame(this.#turn)
    const passed = Math.min(250, Math.max(0, now - this.#before))
    this.#before = now
    if (this.speed === Infinity && !this.#single) this.#hurry()
    else this.#pace((passed * this.#pacing) / MOVE)
    if (now - this.#keptAt > KEEP_EVERY && this.#state === 'playing') {
      this.#keptAt = now
      this.#keep()
    }
  }

  get #pacing() {
    return Number.isFinite(this.speed) ? this.speed : 1
  }

  /** A slice of learning a frame: nothing waits, and no frame is late. */
  #hurry(): void {
    const course = this.#course!
    const end = performance.now() + BUDGET
    do course.advance(SLICE)
    while (!course.over && performance.now() < end)
    this.#show(1)
    if (course.over) this.#end()
  }

  #pace(share: number): void {
    let progress = this.#progress + share
    while (progress >= 1) {
      if (this.#course!.over) return this.#end()
      if (this.#single) return this.#halt('paused')
      this.#course!.next()
      progress = Math.min(progress - 1, 0.99)
      this.#show(progress)
    }
    this.#progress = progress
  }

  #end(): void {
    this.#halt('over')
    this.#finish()
  }

  // ---- the end ----

  #finish(): void {
    const course = this.#course!
    if (!this.#noted) {
      this.#noted = true
      this.#curves = [course.episodes, ...this.#curves.filter((one) => one !== course.episodes)].slice(
        0,
        OVERLAID,
      )
      this.#runs = [...this.#runs, this.#rowOf(course)].slice(-MOST_RUNS)
    }
    this.#keep()
    void this.#draw(true)
  }

  #rowOf(course: Course): LearnedRun {
    const { map, start, goal, closed, settings, episodes: limitEpisodes, moves: limitMoves } = this.outline!
    const { alpha, gamma, nu, rho, rules } = settings
    const { stations } = course.way()
    return {
      ...{ map, start, goal, alpha, gamma, nu, rho, rules, limitEpisodes, limitMoves, seed: this.#seed },
      closed: closed.map((road) => road.join('-')).join(' '),
      ...{ episodes: course.episodes.length, moves: course.made, way: stations?.join('-') ?? '' },
      ...{ shortest: sectionsOf(course) ?? 0, found: course.foundIn() ?? 0, guess: this.guess },
    }
  }

  /** The way becomes the floor of the robot's world; the robot stands on its start, and drives. */
  async #draw(drives: boolean): Promise<void> {
    const { stations } = this.#course!.way()
    const { outline } = this
    if (!stations || stations.length < 2 || outline?.blocks.draw === undefined) return
    const { scene } = drawWay(this.#stage!.map, stations)
    if (!this.#lies(scene.lines)) {
      const { session } = this
      await this.#floors.load(session.lab.document.world, session.pictures)
      session.paint = this.#floors.paint
      session.build(scene)
    }
    if (drives && outline.blocks.drive !== undefined) this.#desk.start()
  }

  #lies = (lines: readonly object[]) =>
    JSON.stringify(this.session.lab.document.world.lines) === JSON.stringify(lines)

  /** Start was pressed: what a program wants learned comes first. Returns whether there is something to learn. */
  #learnFirst(): boolean {
    const { outline } = this
    if (!outline || outline.blocks.experience === undefined || !this.#course) return false
    const { stations } = this.#course.way()
    const learned = (this.#state === 'over' || this.#state === 'stopped') && stations !== null
    if (!learned) {
      this.play()
      return true
    }
    if (outline.blocks.draw !== undefined && !this.#lies(drawWay(this.#stage!.map, stations).scene.lines)) {
      void this.#draw(true)
      return true
    }
    this.session.lab.reset()
    return false
  }

  #keep(): void {
    const moves = this.#course?.made ?? 0
    this.session.keepLearned({
      seed: this.#seed,
      moves,
      key: this.#key,
      noted: this.#noted,
      runs: this.#runs,
    })
  }

  forgetRuns(): void {
    this.#runs = []
    this.#keep()
  }

  // ---- the blocks ----

  setStation(field: 'START' | 'FINISH', station: number): void {
    const { outline } = this
    if (!outline) return
    const [other, now] = field === 'START' ? [outline.goal, outline.start] : [outline.start, outline.goal]
    // Start and goal change places rather than become one.
    if (other === station)
      this.#blocks.setField(outline.blocks.map, field === 'START' ? 'FINISH' : 'START', String(now))
    this.#blocks.setField(outline.blocks.map, field, String(station))
  }

  isClosed(from: number, to: number): boolean {
    return this.outline?.closed.some(([a, b]) => a === from && b === to) ?? false
  }

  /** Closes or opens a road, in one direction or in both. */
  setRoad(from: number, to: number, there: boolean, back: boolean): void {
    const { outline } = this
    if (!outline) return
    const others = outline.closed.filter(([a, b]) => !((a === from && b === to) || (a === to && b === from)))
    const own = [...(there ? [[from, to] as const] : []), ...(back ? [[to, from] as const] : [])]
    this.#blocks.setClosed(outline.blocks.map, [...others, ...own])
  }

  /** A number 0..1 of an expert, a decay, or the rule set. */
  setBehaviour(field: string, value: string): void {
    const id = this.outline?.blocks.behaviour
    if (id !== undefined) this.#blocks.setField(id, field, value)
  }
}
