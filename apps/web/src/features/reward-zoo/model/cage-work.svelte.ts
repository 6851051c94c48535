import type { LoadedCage } from '@botgarten/content/catalogue'
import { isMended, learnIn, paidAt, provedOf, untouched, type Outcome } from '@botgarten/maps/zoo'
import type { Stage } from '#figures/map/stage.ts'
import { noteCage, notedOf } from './notes.ts'
import { Playback } from './playback.svelte.ts'
import { reasonAt } from './reason.ts'
import { watch, type Watched } from './watched.ts'

/** The lab learns with the same dice for everybody. */
const SEED = 1

/** One cage at work: guess, let Bo learn, mend the pay. */
export class CageWork {
  readonly loaded: LoadedCage
  readonly stage: Stage
  readonly playback = new Playback(() => this.watched?.steps.length ?? 0)
  #guess = $state.raw<Outcome | null>(null)
  #setting = $state(0)
  /** The last learned walk, and the setting it was learned with. */
  #latest = $state.raw<Watched | null>(null)
  /** The pay was changed at least once: a cage that is safe from the beginning has to be tried as well. */
  #touched = $state(false)
  #mended = $state(false)

  constructor(loaded: LoadedCage, stage: Stage) {
    this.loaded = loaded
    this.stage = stage
    this.#setting = untouched(loaded.cage)
    const noted = notedOf(loaded.cage.id)
    this.#guess = noted?.guess ?? null
    this.#mended = noted?.mended ?? false
  }

  get cage() {
    return this.loaded.cage
  }
  /** Its pay is right from the beginning: the child is to try whether it can be made to cheat. */
  get isSafe() {
    return this.cage.claim.aLot === 'wish'
  }
  get guess() {
    return this.#guess
  }
  get setting() {
    return this.#setting
  }
  /** The walk learned with the current pay; null before Bo has learned with it. */
  get watched() {
    return this.isOld ? null : this.#latest
  }
  /** Bo has learned in this cage, with any pay. */
  get hasLearned() {
    return this.#latest !== null
  }
  /** What is paid now. */
  get paid() {
    return paidAt(this.cage, this.#setting)
  }
  /** What value iteration says of the pay as it is now, at both discount factors. */
  get proved() {
    return provedOf(this.cage, this.stage.map, this.#setting)
  }
  /** The wish comes true now. */
  get works() {
    return this.#touched && isMended(this.cage, this.stage.map, this.#setting)
  }
  /** It did so once on this device. */
  get mended() {
    return this.#mended
  }
  /** What was learned was learned with another pay. */
  get isOld() {
    return this.#latest !== null && this.#latest.setting !== this.#setting
  }
  get reason() {
    return this.watched && reasonAt(this.cage, this.stage.map, this.#setting)
  }
  /** The move that is shown, and where Bo stands. */
  get step() {
    return this.watched?.steps[this.playback.index] ?? null
  }

  guessThat(guess: Outcome): void {
    this.#guess = guess
    this.#note()
  }

  set(setting: number): void {
    if (setting === this.#setting) return
    this.#setting = setting
    this.#touched = true
    this.playback.stop()
    if (!this.works) return
    this.#mended = true
    this.#note()
  }

  /** Bo learns with the pay as it is, and shows what it has learned. */
  learn(): void {
    if (this.#guess === null) return
    const learned = learnIn(this.cage, this.stage.map, this.#setting, SEED)
    this.#latest = watch(learned, this.#setting)
    this.playback.restart()
  }

  #note(): void {
    if (this.#guess) noteCage(this.cage.id, { guess: this.#guess, mended: this.#mended })
  }
}
