import { untrack } from 'svelte'
import type { Course } from '@botgarten/learning/q-learning'
import { isShortest, learningKey, sectionsOf } from '@botgarten/maps'
import { learningIn, type Learned } from '@botgarten/programs'
import type { LabUi } from '#lab/ui.svelte.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { loadStage, courseOn, type Stage } from '#figures/map/stage.ts'
import { budgetFor, Clock, pauseWhenAway } from './clock.ts'
import { WayOnFloor } from './way-on-floor.ts'
import { type Blocks, Hands } from './hands.ts'
import { MOVE } from './time.ts'
import { Records, rowOf } from './records.svelte.ts'
import { Screen } from './screen.svelte.ts'

/** `over`: a limit stopped it · `stopped`: a hand did. */
export type State = 'ready' | 'playing' | 'paused' | 'over' | 'stopped'

/** After so many moves the clock is looked at again. */
const SLICE = 400
/** The state is kept on the device so often while it plays. */
const KEEP_EVERY = 2000

/** One playground: a course of learning, its map, and the verbs of a child's hand. */
export class Learning {
  readonly session: LabSession
  readonly hands: Hands
  readonly records: Records
  readonly screen = new Screen()
  readonly #ui: LabUi
  readonly #floor: WayOnFloor
  readonly #clock = new Clock((passed, now) => this.#turn(passed, now))
  outline = $derived.by(() => learningIn(this.session.program))
  #key = $derived(this.outline ? learningKey(this.outline) : '')
  #stage = $state.raw<Stage | null>(null)
  #course: Course | null = null
  #state = $state<State>('ready')
  #progress = $state(1)
  /** 1, 2, 3; Infinity: turbo. */
  speed = $state(1)
  guess = $state('')
  #seed = 1
  #keptAt = 0
  /** Has this run been written into the table? */
  #noted = false
  /** One step: the move that is on is the last. */
  #single = false

  constructor(session: LabSession, ui: LabUi, blocks: Blocks) {
    this.session = session
    this.#ui = ui
    this.#floor = new WayOnFloor(session)
    this.hands = new Hands(() => this.outline, blocks)
    const kept = session.learned
    this.records = new Records(kept?.runs ?? [])
    this.#seed = kept?.seed ?? 1
    session.learnFirst = () => this.#learnFirst()
  }

  get stage() {
    return this.#stage
  }
  get shown() {
    return this.screen.told
  }
  get state() {
    return this.#state
  }
  /** 0..1 of the move that is shown. */
  get progress() {
    return this.#progress
  }
  /** Sections of the shortest way; null: there is none. */
  get shortest() {
    return this.#course && sectionsOf(this.#course)
  }

  /** By length where length counts, else by sections. */
  isShortest = (stations: readonly number[]) => this.#course !== null && isShortest(this.#course, stations)

  /** Begins to follow the blocks and to listen to the page. Returns how to end it. */
  open(): () => void {
    const stop = $effect.root(() => {
      $effect(() => {
        const key = this.#key
        untrack(() => void this.#follow(key))
      })
    })
    const leave = pauseWhenAway(() => this.pause())
    return () => {
      stop()
      leave()
      this.pause()
      this.session.learnFirst = () => this.session.learns
    }
  }

  /** The blocks say something else: a new course on the map they name, or the one that was kept. */
  async #follow(key: string): Promise<void> {
    this.#halt('ready')
    const { outline } = this
    if (!outline) return
    const stage = this.#stage?.id === outline.map ? this.#stage : await loadStage(outline.map)
    if (key !== this.#key) return
    this.#stage = stage
    if (!stage || !this.#create()) return
    const kept = this.session.learned
    if (kept?.key === key && kept.moves > 0) await this.#goOn(kept, key)
  }

  #create(): boolean {
    const { outline } = this
    this.#course = null
    this.screen.clear()
    this.#noted = false
    if (!outline || !this.#stage) return false
    this.#course = courseOn(this.#stage, outline, this.#seed)
    this.#show(1)
    return this.#course !== null
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
    this.records.draw(course.episodes)
    this.#state = course.over ? 'over' : 'paused'
  }

  #show(progress: number): void {
    if (!this.#course) return
    this.#progress = progress
    this.screen.show(this.#course)
  }

  // ---- the bar ----

  play(): void {
    if (!this.#course || this.#state === 'playing') return
    if (this.#state === 'over' || this.#state === 'stopped') this.#renew(this.#seed + 1)
    this.session.lab.stop()
    this.#state = 'playing'
    this.#single = false
    this.#clock.start()
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
    this.#clock.start()
  }

  /** From the beginning, with equal dice. */
  again(): void {
    this.#halt('ready')
    this.#renew(this.#seed)
  }

  goTo(move: number): void {
    if (!this.#course) return
    const { state } = this
    const ends = state === 'ready' || state === 'stopped'
    if (!ends) this.#halt('paused')
    this.#course.goTo(move)
    this.#progress = 1
    this.screen.showInTurns(this.#course)
    if (this.#course.over && !ends) this.#state = 'over'
  }

  #renew(seed: number): void {
    this.#seed = seed
    this.#create()
    this.#keep()
  }

  #halt(state: State): void {
    this.#clock.stop()
    const was = this.#state
    this.#state = state
    if (was === 'playing') {
      this.#show(1)
      this.#keep()
    }
  }

  #turn(passed: number, now: number): void {
    if (this.speed === Infinity && !this.#single) this.#hurry(passed)
    else this.#pace((passed * (Number.isFinite(this.speed) ? this.speed : 1)) / MOVE)
    if (now - this.#keptAt > KEEP_EVERY && this.#state === 'playing') {
      this.#keptAt = now
      this.#keep()
    }
  }

  /** A slice of learning a frame: nothing waits, and no frame is late. */
  #hurry(passed: number): void {
    const course = this.#course!
    const end = performance.now() + budgetFor(passed)
    do course.advance(SLICE)
    while (!course.over && performance.now() < end)
    this.#progress = 1
    if (course.over) this.#end()
    else if (!this.screen.isBusy) this.screen.showInTurns(course)
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
    if (!this.#noted) this.records.note(rowOf(this.outline!, course, this.#seed, this.guess), course.episodes)
    this.#noted = true
    this.#keep()
    void this.#draw()
  }

  /** The way becomes the floor of the robot's world, and the robot drives it. */
  async #draw(): Promise<void> {
    const [course, stage, outline] = [this.#course!, this.#stage!, this.outline]
    const { states: stations } = course.way()
    if (!stations || stations.length < 2 || outline?.blocks.draw === undefined) return
    // Meanwhile a hand may have begun again.
    const stands = () =>
      course === this.#course && this.#state !== 'playing' && this.session.lab.view.phase !== 'running'
    await this.#floor.lay(stage, stations, stands)
    if (stands() && outline.blocks.drive !== undefined) this.#ui.start()
  }

  /** Start was pressed: what a program wants learned comes first. Returns whether there is something to learn. */
  #learnFirst(): boolean {
    const { outline } = this
    if (!outline || outline.blocks.experience === undefined || !this.#course) return false
    const { states: stations } = this.#course.way()
    const learned = (this.#state === 'over' || this.#state === 'stopped') && stations !== null
    if (!learned) {
      this.play()
      return true
    }
    if (outline.blocks.draw !== undefined && !this.#floor.lies(this.#stage!, stations)) {
      void this.#draw()
      return true
    }
    this.session.lab.reset()
    return false
  }

  #keep(): void {
    const moves = this.#course?.made ?? 0
    const of = { seed: this.#seed, key: this.#key, noted: this.#noted }
    const { program } = this.session.robot
    const after = { ...of, moves, runs: this.records.runs }
    this.session.apply({ kind: 'learned', program, after })
  }

  forgetRuns(): void {
    this.records.forget()
    this.#keep()
  }
}
