import type { Card } from '@botgarten/content'
import type { Progress } from '@botgarten/programs'
import { samePose, type Pose } from '@botgarten/simulation'

/** How far a child has come with a card: from where it was solved, and how many hints were asked for. */
export class CardProgress {
  readonly #card: Card | undefined
  readonly #starts: () => readonly Pose[]
  #now = $state.raw<Progress>({ starts: [], hints: 0 })
  /** Start pose that the present run began from; null once a hand has helped, −1 for another place. */
  #startedFrom: number | null = null

  /** @param starts poses from which a run counts */
  constructor(card: Card | undefined, progress: Progress | undefined, starts: () => readonly Pose[]) {
    this.#card = card
    this.#starts = starts
    if (progress) this.#now = progress
  }

  get now(): Progress {
    return this.#now
  }

  /** Index of the start pose that this is, −1 for another place. */
  startAt(pose: Pose | undefined): number {
    return pose ? this.#starts().findIndex((start) => samePose(start, pose)) : -1
  }

  /** A run begins with the first robot there. */
  begin(pose: Pose | undefined): void {
    this.#startedFrom = this.startAt(pose)
  }

  /** Does the present run count? It began on a start pose, and no hand has helped. */
  get counts(): boolean {
    return this.#startedFrom !== null && this.#startedFrom >= 0
  }

  /** The present run began on none of the card's start poses. */
  get beganElsewhere(): boolean {
    return this.#card !== undefined && this.#startedFrom === -1
  }

  /** A hand has helped: this run solves nothing. */
  helped(): void {
    this.#startedFrom = null
  }

  /** How far it is now that the card is solved; null where that is nothing new. */
  get solved(): Progress | null {
    const from = this.#startedFrom
    if (from === null || !this.counts || this.#now.starts.includes(from)) return null
    return { ...this.#now, starts: [...this.#now.starts, from].sort() }
  }

  set(progress: Progress): void {
    this.#now = progress
  }
}
