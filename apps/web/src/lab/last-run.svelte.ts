import type { Missing, Phase } from '@botgarten/lab'
import type { Change, LabEvent } from './change.ts'
import type { LabSession } from './session.svelte.ts'

/** Another program, other numbers on its knobs: a try of one's own. */
const tries: readonly Change['kind'][] = ['program', 'blocks', 'brain', 'config']
/** After these what was said of the last run is over. */
const ends: readonly Change['kind'][] = [...tries, 'place', 'scene', 'robots']

const isOn = (phase: Phase) => phase === 'running' || phase === 'paused'

/** What the last run of a card has missed, until something is changed or begun. */
export class LastRun {
  readonly #session: LabSession
  #missed = $state.raw<Missing | null>(null)
  #phase: Phase = 'ready'
  #changed = false
  /** Ids of goals that were reached from this start pose, in whatever run. */
  #earned = $state.raw<readonly string[]>([])
  #tried = $state(false)

  constructor(session: LabSession) {
    this.#session = session
    session.listen((event) => this.#hear(event))
  }

  get earned() {
    return this.#earned
  }
  /**
   * A run from elsewhere than the card's start poses earns nothing.
   * @param green ids of the goals that are reached now
   */
  earns(green: readonly string[]): void {
    if (this.#session.beganElsewhere) return
    const more = green.filter((id) => !this.#earned.includes(id))
    if (more.length > 0) this.#earned = [...this.#earned, ...more]
  }
  /** Another place is another task. */
  forget(): void {
    this.#missed = null
    this.#earned = []
  }
  get missed() {
    return this.#missed
  }
  /** Has a run begun with something changed? */
  get tried() {
    return this.#tried
  }

  /** A run that is over and has left goals open has missed the first of them. A program that broke has another word for it. */
  turns(phase: Phase): void {
    const over = isOn(this.#phase) && !isOn(phase)
    this.#phase = phase
    const { lab, opened } = this.#session
    if (!opened.card || !over || lab.view.tick === 0 || lab.facts.problem) return
    this.#missed = lab.missing()[0] ?? null
  }

  close(): void {
    this.#missed = null
  }

  #hear(event: LabEvent): void {
    if (event.kind === 'begun') {
      this.#missed = null
      this.#tried ||= this.#changed
    }
    if (event.kind !== 'changed' || !ends.includes(event.change.kind)) return
    this.#missed = null
    // A knob that is turned while Bo drives is tried at once.
    const now = isOn(this.#session.lab.facts.phase)
    if (!tries.includes(event.change.kind)) return
    if (now) this.#tried = true
    else this.#changed = true
  }
}
