import { untrack } from 'svelte'
import type { Facts, Finding } from '@botgarten/blocks'
import type { Missing, StepKind } from '@botgarten/lab'
import { told } from './told.ts'
import { saveRaw } from '#storage/handout.ts'
import { readSetting, writeSetting } from '#storage/settings.ts'
import { isTyping, undoKey } from './keys.ts'
import type { PaneName, PaneSizes } from './panes.ts'
import type { LabSession } from './session.svelte.ts'
import { LastRun } from './last-run.svelte.ts'
import { Loudspeaker } from './sound.svelte.ts'

/** What is said at the foot of the world, as `session.<notice>`. */
export type Notice = 'away' | 'bumped' | 'elsewhere' | 'floorMissing'

/** Milliseconds in which a short note is read. */
const readable = 4000

/** Simulated seconds a real second, from the second place on. */
const furtherPlaces = 4

/** What is said in a dialog: keys of words, so that it follows the language. */
export interface Message {
  readonly title: string
  readonly text: string
  readonly facts: Facts
  /** Saves as a file what could not be read. */
  readonly onsaveraw?: () => void
}

interface Settings {
  readonly rays: boolean
  /** Rays of all sensors, not only of those that the program reads. */
  readonly all?: boolean | undefined
  readonly trail: boolean
}

/** What is open, chosen and said on the screen round a session, what is switched on, how it sounds. */
export class LabUi {
  readonly speaker = new Loudspeaker()
  #session: LabSession
  #shown = $state.raw<Finding | null>(null)
  /** All goals are green, in a run that counts or in one that does not. */
  #success = $state<'counts' | 'uncounted' | null>(null)
  /** Has this run succeeded before? */
  #succeeded = false
  readonly #last: LastRun
  /** The speed that was chosen, while further places run quicker. */
  #ownSpeed: number | null = null
  #over: ReturnType<typeof setTimeout> | undefined
  #settings = $state.raw(readSetting<Settings>('settings', { rays: true, trail: true }))
  #sizes = $state.raw(readSetting<PaneSizes>('sizes', {}))
  /** Which pane is on the screen where there is room for one, and which one fills it. */
  page = $state<PaneName>('world')
  filled = $state<PaneName | null>(null)
  /** The pane that a hand has touched last: the step is of it. */
  touched = $state<PaneName | null>(null)
  cardOpen = $state(false)
  hintOpen = $state(false)
  notice = $state.raw<Notice | null>(null)
  message = $state.raw<Message | null>(null)

  constructor(session: LabSession) {
    this.#session = session
    this.#last = new LastRun(session)
    const { error } = session.opened
    if (error === 'floorMissing') this.notice = error
    const { damaged } = session.opened
    if (damaged)
      this.message = {
        ...{ title: `session.${error}`, text: `session.${error}Text`, facts: {} },
        onsaveraw: () => saveRaw(damaged.name, damaged.raw),
      }
  }

  get shown() {
    return this.#shown
  }
  get success() {
    return this.#success
  }
  /** What the last run has missed; null while one is on, and after an edit. */
  get missed(): Missing | null {
    return this.#last.missed
  }
  /** Has something been changed and tried since the card was opened? */
  get tried() {
    return this.#last.tried
  }
  /** Goals that were reached from this place in some run, by id. */
  get earned() {
    return this.#last.earned
  }
  closeMissed(): void {
    this.#last.close()
  }
  get settings() {
    return this.#settings
  }
  set settings(settings: Settings) {
    this.#settings = settings
    writeSetting('settings', settings)
  }
  get sizes() {
    return this.#sizes
  }
  set sizes(sizes: PaneSizes) {
    this.#sizes = sizes
    writeSetting('sizes', sizes)
  }

  /** Begins to let time pass and to listen to the page. Returns how to end it. */
  open(): () => void {
    const { lab, autosave } = this.#session
    const stopFrames = lab.run()
    const stopWatching = $effect.root(() => {
      const { phase, heard, problem, succeeded, touching, green } = $derived(lab.facts)
      $effect(() => this.speaker.play(phase === 'running' ? heard : null))
      $effect(() => {
        const failure = problem
        untrack(() => this.#failed(failure))
      })
      $effect(() => {
        const now = phase
        untrack(() => this.#last.turns(now))
      })
      $effect(() => {
        const ids = green.split(' ').filter(Boolean)
        untrack(() => this.#last.earns(ids))
      })
      $effect(() => {
        if (succeeded) untrack(() => this.#succeed())
      })
      $effect(() => {
        if (phase !== 'running' || !this.bumpIsMistake) return
        if (touching) this.notice = 'bumped'
        else untrack(() => this.#soonOver())
      })
      $effect(() => {
        // Who looks again goes on; who edits has another run.
        if (phase === 'running' && untrack(() => this.notice) === 'away') this.notice = null
      })
    })
    const away = () => this.#turnedAway()
    const press = (event: KeyboardEvent) => this.#press(event)
    document.addEventListener('visibilitychange', away)
    window.addEventListener('keydown', press)
    return () => {
      document.removeEventListener('visibilitychange', away)
      window.removeEventListener('keydown', press)
      clearTimeout(this.#over)
      stopWatching()
      stopFrames()
      this.speaker.close()
      autosave.close()
    }
  }

  /** In the free lab things are pushed, and who learns by trying has to bump. */
  get bumpIsMistake(): boolean {
    return this.#session.opened.card !== null && !this.#session.tries
  }

  /** Bo is free again: that it bumped can still be read for a while. */
  #soonOver(): void {
    if (this.notice !== 'bumped') return
    clearTimeout(this.#over)
    this.#over = setTimeout(() => this.notice === 'bumped' && (this.notice = null), readable)
  }

  #press(event: KeyboardEvent): void {
    if (event.key === 'Escape' && this.hintOpen) this.hintOpen = false
    else if (event.key === 'Escape') this.#session.lab.stop()
    const direction = undoKey(event)
    if (direction === null || isTyping(event.target)) return
    event.preventDefault()
    this.go(direction)
  }

  /** Takes a step back or goes one forth. */
  go(direction: 'undo' | 'redo'): void {
    void told().then(() => {
      this.#session.lab.goTo(Infinity)
      this.#session.undo[direction]()
    })
  }

  /** A hidden page pauses the run and says so on return (running.md 12). */
  #turnedAway(): void {
    if (!document.hidden) return
    void this.#session.autosave.flush()
    if (this.#session.lab.view.phase !== 'running') return
    this.#session.lab.pause()
    this.notice = 'away'
  }

  /** Once a run, however often the checks turn green in it. */
  #succeed(): void {
    if (this.#succeeded) return
    this.#succeeded = true
    this.hintOpen = false
    this.#success = this.#session.noteSuccess() ? 'counts' : 'uncounted'
  }

  closeSuccess(): void {
    this.#success = null
  }

  /** Goes on from the next place at once; who has shown it once need not watch it in real time. */
  startNext(index: number): void {
    const { lab } = this.#session
    this.chooseStart(index)
    if (lab.speed < furtherPlaces) [this.#ownSpeed, lab.speed] = [lab.speed, furtherPlaces]
    this.speaker.wake()
    void told().then(() => this.#begin())
  }

  /** A run that begins by itself has the speed that was chosen. */
  #slowDown(): void {
    const { lab } = this.#session
    if (this.#ownSpeed !== null && lab.speed === furtherPlaces) lab.speed = this.#ownSpeed
    this.#ownSpeed = null
  }

  /** Starts the program as the hand has left it: blocks that it has just joined run with it. */
  start(): void {
    // Browsers let a page sound only while a press is being answered.
    this.speaker.wake()
    this.#slowDown()
    void told().then(() => this.#begin())
  }

  #begin(): void {
    this.notice = null
    this.#succeeded = false
    this.#success = null
    this.#shown = this.#session.start()
    if (this.#session.lab.view.phase === 'running' && this.#session.beganElsewhere) this.notice = 'elsewhere'
  }

  /** Puts Bo on one of the card's start poses: what was said about the run before is over. */
  chooseStart(index: number): void {
    this.notice = null
    this.#success = null
    this.#last.forget()
    this.#session.chooseStart(index)
  }

  /** Puts everything back; on a card Bo comes to a place that counts. */
  toStart(): void {
    this.notice = null
    this.#success = null
    this.#session.toStart()
  }

  step(kind: StepKind): void {
    this.speaker.wake()
    void told().then(() => {
      const { phase } = this.#session.lab.view
      if (phase === 'ready' || phase === 'ended') this.#begin()
      if (!this.#shown) this.#session.lab.step(kind)
    })
  }

  /** A program that cannot go on is shown, whosever it is. */
  #failed(problem: Finding | null): void {
    const robot = this.#session.lab.view.robots.find((one) => one.problem === problem)
    if (problem && robot) this.#session.choose(robot.id)
    this.show(problem)
  }

  show(finding: Finding | null): void {
    this.#shown = finding
  }

  announce(title: string, text: string, facts: Facts = {}): void {
    this.message = { title, text, facts }
  }
}
