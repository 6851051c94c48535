import type { PracticeNote } from '@botgarten/learning/neural-network'
import { byHeartSince, type CurvePoint, type Ending } from '@botgarten/learning/neural-network/train'

/** What has come of a practice so far, and which of its rounds is shown. */
export class Outcome {
  #curve = $state.raw<readonly CurvePoint[]>([])
  #marks = $state.raw<readonly number[]>([])
  #round = $state(0)
  #ending = $state.raw<Ending | null>(null)
  #sleeping = $state.raw<readonly string[]>([])
  #shaken = $state(false)
  readonly last = $derived.by(() => this.#curve.at(-1)?.round ?? 0)
  /** The errors of the round whose weights are on the knobs. */
  readonly point = $derived.by(() => this.#curve.findLast(({ round }) => round <= this.#round) ?? null)
  readonly byHeart = $derived.by(() => byHeartSince(this.#curve))

  get curve() {
    return this.#curve
  }
  /** Rounds with which Bo has driven. */
  get marks() {
    return this.#marks
  }
  /** Whose weights are on the knobs. */
  get round() {
    return this.#round
  }
  get ending() {
    return this.#ending
  }
  /** Ids of hidden neurons that no example wakes. */
  get sleeping() {
    return this.#sleeping
  }
  /** Did it begin with a draw, because there are hidden neurons? */
  get shaken() {
    return this.#shaken
  }

  /** Takes up what the project says of a practice. */
  adopt(note: PracticeNote | undefined): void {
    ;[this.#curve, this.#marks, this.#round] = [note?.curve ?? [], note?.marks ?? [], note?.round ?? 0]
    ;[this.#ending, this.#sleeping, this.#shaken] = [null, [], false]
  }

  /** A practice of its own begins. */
  begin(shaken: boolean): void {
    ;[this.#curve, this.#marks, this.#round, this.#shaken] = [[], [], 0, shaken]
  }

  /** It goes on from the round that is shown: what came after that one becomes another future. */
  goOn(): void {
    this.#ending = null
    this.#curve = this.#curve.filter(({ round }) => round <= this.#round)
    this.#marks = this.#marks.filter((mark) => mark <= this.#round)
  }

  measure(points: readonly CurvePoint[]): void {
    const known = this.#curve.at(-1)?.round ?? -1
    this.#curve = [...this.#curve, ...points.filter(({ round }) => round > known)]
  }

  show(round: number): void {
    this.#round = round
  }

  end(ending: Ending | null, sleeping = this.#sleeping): void {
    ;[this.#ending, this.#sleeping] = [ending, sleeping]
  }

  /** Bo drives with the round that is shown. Returns whether that is a mark more. */
  mark(): boolean {
    if (this.#curve.length === 0 || this.#marks.includes(this.#round)) return false
    this.#marks = [...this.#marks, this.#round].sort((a, b) => a - b)
    return true
  }
}
