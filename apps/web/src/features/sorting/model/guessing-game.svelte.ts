import type { ThingSet } from '@botgarten/content/things'
import { judge, roundsOf, type Verdict } from './guessing.ts'

/** One child chooses in secret · the groups come about · the other guesses · the answer is shown. */
type Stage = 'choose' | 'sort' | 'guess' | 'shown'

const GROUPS = 3

/** Two play on one device: one chooses in secret what counts, the other guesses it from the groups. */
export class GuessingGame {
  readonly set: ThingSet
  #secret = $state.raw<readonly string[]>([])
  #guess = $state.raw<readonly string[]>([])
  #stage = $state<Stage>('choose')
  #round = $state(0)
  #verdict = $state.raw<Verdict | null>(null)
  rounds = $derived.by(() => (this.#secret.length > 0 ? roundsOf(this.set, this.#secret, GROUPS) : []))

  constructor(set: ThingSet) {
    this.set = set
  }

  get secret() {
    return this.#secret
  }
  get guess() {
    return this.#guess
  }
  get stage() {
    return this.#stage
  }
  /** Of the sorting that is shown; 0: all lie in a heap. */
  get round() {
    return this.#round
  }
  get verdict() {
    return this.#verdict
  }
  /** The features that are chosen in this stage. */
  get ticked() {
    return this.#stage === 'choose' ? this.#secret : this.#guess
  }
  get over() {
    return this.#stage === 'shown' || (this.#verdict !== null && this.#verdict.kind !== 'wrong')
  }
  /** The groups of the round that is shown; the last ones while it is guessed. */
  get groups(): readonly (readonly number[])[] {
    if (this.#stage !== 'sort') return this.rounds.at(-1) ?? []
    return this.rounds[this.#round - 1] ?? Array.from({ length: GROUPS }, () => [])
  }
  /** What lies in no group yet. */
  get heap(): readonly number[] {
    return this.#stage === 'sort' && this.#round === 0 ? this.set.things.map((_, thing) => thing) : []
  }

  tick(feature: string): void {
    const { ticked } = this
    const next = ticked.includes(feature) ? ticked.filter((one) => one !== feature) : [...ticked, feature]
    if (this.#stage === 'choose') this.#secret = next
    else [this.#guess, this.#verdict] = [next, null]
  }

  sort(): void {
    this.#stage = 'sort'
  }

  /** One round further; behind the last one the other child is asked. */
  next(): void {
    if (this.#round < this.rounds.length) this.#round += 1
    else this.#stage = 'guess'
  }

  check(): void {
    this.#verdict = judge(this.set, this.#secret, this.#guess, GROUPS)
  }

  show(): void {
    this.#stage = 'shown'
  }

  /** The children change places: all begins again. */
  swap(): void {
    this.#secret = []
    this.#guess = []
    this.#verdict = null
    this.#stage = 'choose'
    this.#round = 0
  }
}
