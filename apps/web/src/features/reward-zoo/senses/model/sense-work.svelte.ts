import type { LoadedSenseCage } from '@botgarten/content/catalogue'
import type { SenseGuess } from '@botgarten/content/sense-cage'
import { shownIn } from '@botgarten/experiments/cages'
import { limits, problemOf, unitOf, type PayKind, type Sentence } from '@botgarten/learning/q-senses'
import type { Grounds, Order, Report, Seen } from './messages.ts'
import { newWorker } from './new-worker.ts'
import { noteCage, notedOf } from './notes.ts'
import { Player } from './player.svelte.ts'

/** A sentence as a child reads it: a coin for 4 cm of a way. */
const inCoins = ({ for: kind, coins }: Sentence): Sentence => ({ for: kind, coins: coins * unitOf(kind) })
const inUnits = ({ for: kind, coins }: Sentence): Sentence => ({ for: kind, coins: coins / unitOf(kind) })

/** One cage at work: predict, watch, mend the pay, watch again. */
export class SenseWork {
  readonly loaded: LoadedSenseCage
  readonly player = new Player()
  readonly grounds: Grounds
  #guess = $state.raw<SenseGuess | null>(null)
  #pay = $state.raw<readonly Sentence[]>([])
  /** What was driven last; null before it was watched. */
  #seen = $state.raw<Seen | null>(null)
  /** Minutes of trying that are over while it learns; null: it does not. */
  #minute = $state<number | null>(null)
  #busy = $state(false)
  #mended = $state(false)
  #failed = $state(false)
  #tried: string | null = null
  #seed: number
  #worker: Worker | null = null

  constructor(loaded: LoadedSenseCage, grounds: Grounds) {
    this.loaded = loaded
    this.grounds = grounds
    this.#pay = loaded.cage.trial.pay.map(inCoins)
    this.#seed = loaded.rows.shown.seed
    const noted = notedOf(loaded.cage.id)
    this.#guess = noted?.guess ?? null
    this.#mended = noted?.mended ?? false
  }

  get cage() {
    return this.loaded.cage
  }
  /** Does the robot that is watched first do what the cage is named after? */
  get shownCheats() {
    const { bos, shown } = this.loaded.rows
    return bos.find(({ seed }) => seed === shown.seed)!.cheats
  }
  get guess() {
    return this.#guess
  }
  /** In the child's coins. */
  get pay() {
    return this.#pay
  }
  get seen() {
    return this.#seen
  }
  get minute() {
    return this.#minute
  }
  get busy() {
    return this.#busy
  }
  get seed() {
    return this.#seed
  }
  /** It was mended once on this device. */
  get mended() {
    return this.#mended
  }
  /** The worker could not learn. */
  get failed() {
    return this.#failed
  }
  /** What is driven was learned with the cage's own pay. */
  get isCagePay() {
    return this.#seen !== null && JSON.stringify(this.#seen.table.pay) === JSON.stringify(this.cage.trial.pay)
  }
  /** What is driven was learned with the pay as it is now. */
  get isNow() {
    return (
      this.#seen !== null && JSON.stringify(this.#seen.table.pay.map(inCoins)) === JSON.stringify(this.#pay)
    )
  }
  /** Why nothing can be learned with this pay; null: it can. */
  get problem() {
    return problemOf({ ...this.cage.trial, seed: 0, pay: this.#pay })
  }
  get isFull() {
    return this.#pay.length >= limits.sentences
  }

  guessThat(guess: SenseGuess): void {
    if (this.#seen) return
    this.#guess = guess
    this.#note(false)
  }

  setKind(index: number, kind: PayKind): void {
    this.#change(index, { ...this.#pay[index]!, for: kind })
  }

  /** What is no number, or beyond 20 coins, goes to the nearest that can be. */
  setCoins(index: number, coins: number): void {
    const value = Number.isFinite(coins) ? coins : this.#pay[index]!.coins
    this.#change(index, {
      ...this.#pay[index]!,
      coins: Math.max(-limits.coins, Math.min(limits.coins, value)),
    })
  }

  #change(index: number, sentence: Sentence): void {
    this.#set(this.#pay.map((one, at) => (at === index ? sentence : one)))
  }

  add(): void {
    if (!this.isFull) this.#set([...this.#pay, { for: 'bump', coins: -5 }])
  }

  remove(index: number): void {
    this.#set(this.#pay.filter((_, at) => at !== index))
  }

  restore(): void {
    this.#set(this.cage.trial.pay.map(inCoins))
  }

  /** Stops a drive that was learned with another pay. */
  #set(pay: readonly Sentence[]): void {
    this.#pay = pay
    if (!this.isNow) this.player.stop()
  }

  /** Bo drives what it has learned with the cage's own pay. */
  watch(): void {
    if (this.#guess === null) return
    this.#send({ kind: 'watch', table: shownIn(this.cage, this.loaded.rows) })
  }

  /** Bo learns with the pay as it is; the same pay again is learned by another Bo. */
  learn(): void {
    if (this.problem || this.#busy) return
    const pay = this.#pay.map(inUnits)
    const asked = JSON.stringify(pay)
    this.#seed = this.#tried === asked ? this.#seed + 1 : this.loaded.rows.shown.seed
    this.#tried = asked
    this.#minute = 0
    this.#send({ kind: 'learn', pay, seed: this.#seed })
  }

  stop(): void {
    this.#worker?.terminate()
    this.#worker = null
    this.#busy = false
    this.#minute = null
  }

  close(): void {
    this.stop()
    this.player.stop()
  }

  #send(order: Order): void {
    const worker = (this.#worker ??= this.#opened())
    this.#busy = true
    this.#failed = false
    this.player.stop()
    worker.onmessage = ({ data }: MessageEvent<Report>) => this.#take(data)
    worker.onerror = () => {
      this.stop()
      this.#failed = true
    }
    worker.postMessage(order)
  }

  #opened(): Worker {
    const worker = newWorker()
    worker.postMessage({ kind: 'open', cage: this.cage, grounds: this.grounds } satisfies Order)
    return worker
  }

  #take(report: Report): void {
    if (report.kind === 'minute') {
      this.#minute = report.minute
      return
    }
    const { seen } = report
    this.#busy = false
    this.#minute = null
    this.#seen = seen
    this.#mended ||= seen.minute !== null
    this.#note(true)
    this.player.show(seen.watched)
  }

  #note(watched: boolean): void {
    if (this.#guess)
      noteCage(this.cage.id, {
        guess: this.#guess,
        watched: watched || (notedOf(this.cage.id)?.watched ?? false),
        mended: this.#mended,
      })
  }
}
