import type { Effort } from '@botgarten/programs'
import type { Change, LabEvent, Part } from './change.ts'

/** Milliseconds after which a hand was away. */
const AWAY = 30_000

const none: Effort = { knobs: 0, starts: 0, bumps: 0, hand: 0, computer: 0 }

/** Changes that the lab makes by itself. */
const byItself: readonly Change['kind'][] = ['progress', 'learned', 'table']

/** Counts what goes into a project while it is in a child's hands. It is saved with the next change. */
export class EffortCount {
  #counted: Effort
  #last: number | null = null
  /** Of the run that is on the screen, as far as they are counted. */
  #bumps = 0
  readonly #now: () => number

  /** @param now milliseconds */
  constructor(before: Effort = none, now = () => performance.now()) {
    this.#counted = before
    this.#now = now
  }

  /** Undefined: nothing has gone into it yet. */
  get sum(): Effort | undefined {
    return Object.values(this.#counted).some((count) => count > 0) ? this.#counted : undefined
  }

  #add(more: Partial<Effort>): void {
    const { knobs = 0, starts = 0, bumps = 0, hand = 0, computer = 0 } = more
    const before = this.#counted
    this.#counted = {
      knobs: before.knobs + knobs,
      starts: before.starts + starts,
      bumps: before.bumps + bumps,
      hand: before.hand + hand,
      computer: before.computer + computer,
    }
  }

  /** A hand is on it. */
  touch(): void {
    const now = this.#now()
    const pause = this.#last === null ? AWAY : now - this.#last
    this.#last = now
    if (pause < AWAY) this.#add({ hand: pause / 1000 })
  }

  /** A hand changes something. A pull counts when it ends. */
  change({ kind }: Change, part: Part): void {
    if (kind === 'weight' && (part === 'whole' || part === 'end')) this.#add({ knobs: 1 })
  }

  hear = (event: LabEvent): void => {
    if (event.kind === 'begun') this.#add({ starts: 1 })
    if (event.kind !== 'changed' || !byItself.includes(event.change.kind)) this.touch()
  }

  /** @param bumps of the run that is on the screen; fewer than before: it is another one, or a hand went back in time */
  bumped(bumps: number): void {
    const more = bumps - this.#bumps
    this.#bumps = bumps
    if (more > 0) this.#add({ bumps: more })
  }

  /** The computer has practised or tried. @param bumps in tries that were not on the screen */
  computed(seconds: number, bumps = 0): void {
    this.#add({ computer: seconds, bumps })
  }
}
