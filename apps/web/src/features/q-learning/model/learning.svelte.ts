import { untrack } from 'svelte'
import type { Course } from '@botgarten/learning/q-learning'
import { isShortest, sectionsOf } from '@botgarten/maps'
import type { Learned } from '@botgarten/programs'
import type { LabUi } from '#lab/ui.svelte.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { courseOn, type Stage } from '#figures/map/stage.ts'
import { atMostEvery, pauseWhenAway, replay } from './clock.ts'
import { throwSeed } from './dice.ts'
import { Drive, type LearnedWay } from './drive.svelte.ts'
import { Guessing } from './guessing.svelte.ts'
import type { Blocks } from './block-edits.ts'
import { Player } from './player.svelte.ts'
import { Records, rowOf } from './records.svelte.ts'
import { Screen } from './screen.svelte.ts'
import { Task } from './task.svelte.ts'
import { Watch } from './watch.svelte.ts'

/** `over`: a limit of the program ended it · `stopped`: the user did. */
export type State = 'ready' | 'playing' | 'paused' | 'over' | 'stopped'

/** Milliseconds between two saves while it plays. */
const KEEP_EVERY = 2000

/** A playground: a course of learning, its map, and the actions of the user on both. */
export class Learning {
  readonly session: LabSession
  readonly records: Records
  readonly screen = new Screen()
  /** The user's guess of the shortest way, before Bo learns. */
  readonly guess = new Guessing()
  readonly drive: Drive
  /** Bo walks on the map as it has learned. */
  readonly watch = new Watch()
  readonly player = new Player({
    screen: this.screen,
    course: () => this.#course!,
    onend: () => this.#end(),
    onpause: () => this.#halt('paused'),
    onframe: atMostEvery(KEEP_EVERY, () => this.#keep()),
  })
  readonly task: Task
  #course: Course | null = null
  #stage = $state.raw<Stage | null>(null)
  #state = $state<State>('ready')
  #seed = $state(1)
  readonly #startsOfCard: LabSession['starts']
  /** False until the first task has been opened. */
  #hasTask = false
  #isOpen = false
  /** Has this run been added to the table of experiments? */
  #noted = false

  /** @param pinned seed from the address; null: that of the project, or a random one */
  constructor(session: LabSession, ui: LabUi, blocks: Blocks, pinned: number | null) {
    this.session = session
    this.drive = new Drive(session, ui, () => this.#learned())
    this.task = new Task(session, blocks)
    const kept = session.learned
    this.records = new Records(kept?.runs ?? [])
    this.#seed = pinned ?? kept?.seed ?? throwSeed()
    session.learnFirst = () => this.#learnFirst()
    this.#startsOfCard = session.starts
    // On a way that is not the learned one no start counts: Bo goes back to the place that it was moved to.
    session.starts = () => this.drive.starts ?? (session.below ? [] : this.#startsOfCard())
  }

  get outline() {
    return this.task.outline
  }
  /** The map of the course. It stays the earlier one until the map that the block names has loaded. */
  get stage() {
    return this.#stage
  }
  get edits() {
    return this.task.edits
  }
  get shown() {
    return this.screen.told
  }
  get state() {
    return this.#state
  }
  /** Seed of the random stream: with the same seed the same is learned. */
  get seed() {
    return this.#seed
  }
  /** Has a limit or the user ended it? */
  get ended() {
    return this.#state === 'over' || this.#state === 'stopped'
  }
  /** Is what was guessed compared with what came out? */
  get compares() {
    return this.ended && this.guess.isDone && this.guess.compares
  }
  /** How much of the shown move has been animated, 0..1. */
  get progress() {
    return this.player.progress
  }
  /** Sections of the shortest way; null: there is none. */
  get shortest() {
    return this.#course && sectionsOf(this.#course)
  }

  /** Is a way as short as the shortest one? By length if roads cost their length, else by number of roads. */
  isShortest = (stations: readonly number[]) => this.#course !== null && isShortest(this.#course, stations)

  /** Starts to follow the blocks and the page. Returns the function that ends this. */
  open(): () => void {
    const { session } = this
    this.#isOpen = true
    const stop = $effect.root(() => {
      $effect(() => {
        const { key } = this.task
        untrack(() => void this.#follow(key))
      })
      $effect(() => {
        if (this.task.question) untrack(() => this.guess.forget())
      })
      $effect(() => {
        if (session.lab.facts.phase === 'running') untrack(() => this.drive.comeForward())
      })
      $effect(() => this.drive.showMap(this.stage))
      $effect(() => {
        const { facts, view } = session.lab
        if (facts.phase === 'running') untrack(() => this.drive.endAtGoal(view))
      })
    })
    const leave = pauseWhenAway(() => this.pause())
    return () => {
      this.#isOpen = false
      stop()
      leave()
      this.pause()
      this.watch.stop()
      this.session.learnFirst = () => this.session.learns
      this.session.starts = this.#startsOfCard
      this.drive.showMap(null)
      // A way that is being drawn must not reach the project that is open next: without a course it is not wanted.
      this.#clear()
    }
  }

  /** The task in the blocks has changed: begins its course, or restores the saved one. */
  async #follow(key: string): Promise<void> {
    this.#halt('ready')
    // Bo may still drive for the earlier task.
    if (this.#hasTask && this.session.lab.facts.phase === 'running') this.session.lab.stop()
    this.#hasTask = true
    this.drive.front = 'map'
    const { task } = this
    if (!task.outline) return
    if (!task.hasMap) {
      this.#clear()
      await task.loadMap()
    }
    if (key !== task.key || !this.#isOpen || !this.#create()) return
    const kept = this.session.learned
    if (kept?.key === key && kept.seed === this.#seed && kept.moves > 0) await this.#goOn(kept, key)
  }

  #clear(): void {
    this.#course = null
    this.#stage = null
    this.screen.clear()
    this.#noted = false
  }

  #create(): boolean {
    this.#clear()
    const { outline } = this
    const { stage } = this.task
    this.#stage = stage
    if (!outline || !stage) return false
    this.#course = courseOn(stage, outline, this.#seed)
    this.#show(1)
    return this.#course !== null
  }

  /** Restores saved progress: only the number of moves is saved, and the same seed repeats them (running.md 2). */
  async #goOn(kept: Learned, key: string): Promise<void> {
    const course = this.#course!
    const isWanted = () => key === this.task.key && course === this.#course
    if (!(await replay(course, kept.moves, isWanted))) return
    this.#noted = kept.noted
    this.#show(1)
    this.records.draw(course.episodes)
    this.#state = course.over ? 'over' : 'paused'
  }

  #show(progress: number): void {
    this.watch.stop()
    if (this.#course) this.player.show(progress)
  }

  /** Does Bo walk on the map, because no way can be driven: a circle, moves by chance, or no block that drives? */
  get walks() {
    const { shown, outline } = this
    if (!this.ended || !shown || shown.t === 0 || shown.way.reason === 'neverReached') return false
    return shown.way.states === null || outline?.blocks.drive === undefined
  }

  walk(): void {
    if (!this.#course) return
    this.drive.front = 'map'
    this.watch.start(this.#course, this.#seed)
  }

  // ---- the guess ----

  /** Taps on the map make a guess from now on. After moves have been made, begins another learning. */
  guessFirst(): void {
    if (!this.#course) return
    this.#halt('ready')
    if (this.#course.made > 0) this.#renew(this.#seed + 1)
    this.drive.front = 'map'
    this.guess.begin(this.#course.learner.world)
  }

  skipGuess(): void {
    this.guess.forget()
    this.play()
  }

  // ---- the bar ----

  play(): void {
    if (!this.#course || this.#state === 'playing') return
    if (this.ended) this.#renew(this.#seed + 1)
    this.#begin(false)
  }

  pause(): void {
    if (this.#state === 'playing') this.#halt('paused')
  }

  /** Ends this learning; its values stay. */
  stop(): void {
    if (!this.#course || this.#state === 'ready') return
    this.#halt('stopped')
    this.#finish()
  }

  /** Makes one move after the shown one. */
  step(): void {
    if (!this.#course || this.ended) return
    if (this.#state === 'playing') this.player.endAfterMove()
    else if (this.#course.next()) {
      this.#show(0)
      this.#begin(true)
    } else this.#end()
  }

  #begin(single: boolean): void {
    this.watch.stop()
    this.session.lab.stop()
    this.guess.close()
    this.drive.front = 'map'
    this.#state = 'playing'
    this.player.start(single)
  }

  /** From the beginning, with the same seed. */
  again(): void {
    this.#halt('ready')
    this.#renew(this.#seed)
  }

  goTo(move: number): void {
    if (!this.#course) return
    this.watch.stop()
    const { state } = this
    const ends = state === 'ready' || state === 'stopped'
    if (!ends) this.#halt('paused')
    this.#course.goTo(move)
    this.player.showInTurns()
    if (this.#course.over && !ends) this.#state = 'over'
  }

  #renew(seed: number): void {
    this.#seed = seed
    this.#create()
    this.#keep()
  }

  #halt(state: State): void {
    this.player.stop()
    const was = this.#state
    this.#state = state
    if (was === 'playing') {
      this.#show(1)
      this.#keep()
    }
  }

  #end(): void {
    this.#halt('over')
    this.#finish()
  }

  // ---- the end ----

  #finish(): void {
    const course = this.#course!
    if (!this.#noted)
      this.records.note(rowOf(this.outline!, course, this.#seed, this.guess.text), course.episodes)
    this.#noted = true
    this.#keep()
    // After a guess the user compares it with the way first, and starts Bo then.
    void this.drive.draw(!this.guess.isDone)
    if (this.walks) this.walk()
  }

  /** Start was pressed: learns, or draws the way, before the program runs. Returns false if it can run now. */
  #learnFirst(): boolean {
    const { outline } = this
    if (!outline || outline.blocks.experience === undefined || !this.#course) return false
    if (this.#learned() === null) {
      this.play()
      return true
    }
    if (this.drive.drawFirst()) return true
    this.session.lab.reset()
    return false
  }

  #learned(): LearnedWay | null {
    const { stage, outline } = this
    const stations = this.ended ? this.#course?.way().states : null
    return stations && stage && outline
      ? { course: this.#course!, stage, stations, blocks: outline.blocks }
      : null
  }

  #keep(): void {
    const moves = this.#course?.made ?? 0
    const of = { seed: this.#seed, key: this.task.key, noted: this.#noted }
    const { program } = this.session.robot
    const after = { ...of, moves, runs: this.records.runs }
    this.session.apply({ kind: 'learned', program, after })
  }

  forgetRuns(): void {
    this.records.forget()
    this.#keep()
  }
}
