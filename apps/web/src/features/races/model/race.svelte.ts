import {
  criteriaOn,
  limits,
  orderOf,
  pointsOf,
  winnersOf,
  type Criterion,
  type Lane,
  type LaneResult,
  type Race,
} from '@botgarten/experiments/race'
import { laneOf } from './lanes.ts'
import { Playback } from './playback.svelte.ts'
import { Runners } from './runners.ts'
import type { Track } from './track.ts'
import { resultOfWalk, type Tried } from './walked.ts'

/** A learner, or `me`: the user with the recorded tries. */
export type Runner = Lane | { readonly racer: 'me'; readonly tries: readonly Tried[] }

/** A race as it was run: what is shown until the next one. */
export interface Run {
  readonly race: Race
  readonly runners: readonly Runner[]
  readonly criterion: Criterion
  readonly points: readonly number[]
  readonly results: readonly LaneResult[]
  readonly winners: readonly number[]
  /** From best to worst. */
  readonly order: readonly number[]
}

/** The settings of a race, and the last race that was run. */
export class RaceModel {
  readonly track: Track
  readonly offered: readonly Criterion[]
  /** Null: nothing is chosen yet, so nothing starts. */
  criterion = $state<Criterion | null>(null)
  runners = $state.raw<readonly Runner[]>([laneOf('q'), laneOf('sarsa'), laneOf('best'), laneOf('random')])
  tries = $state(100)
  runs = $state(20)
  sameDice = $state(false)
  seed = $state(1)
  /** 0..1 while it runs, else null. */
  share = $state<number | null>(null)
  last = $state.raw<Run | null>(null)
  readonly playback = new Playback()
  readonly #workers = new Runners()

  constructor(track: Track) {
    this.track = track
    this.offered = criteriaOn(track.task)
  }

  get me() {
    return this.runners.find((one) => one.racer === 'me')
  }
  /** Tries of each lane: as many as the user has made, if the user takes part. */
  get triesOfAll() {
    return this.me?.racer === 'me' ? this.me.tries.length : this.tries
  }
  get isFull() {
    return this.runners.length >= limits.lanes.most
  }
  /** Can a lane be removed? A race needs two lanes, one of them a learner. */
  get canDrop() {
    return this.runners.length > limits.lanes.least
  }

  add(runner: Runner): void {
    const others = this.runners.filter(({ racer }) => racer !== 'me' || runner.racer !== 'me')
    this.runners = [...others, runner].slice(-limits.lanes.most)
  }
  change(index: number, runner: Runner): void {
    this.runners = this.runners.with(index, runner)
  }
  drop(index: number): void {
    if (this.canDrop) this.runners = this.runners.toSpliced(index, 1)
  }

  /** Runs the race. The next one uses another seed. */
  async start(): Promise<void> {
    const { criterion, runners } = this
    if (!criterion || this.share !== null) return
    if (this.last) this.seed++
    this.share = 0
    const lanes = runners.filter((one): one is Lane => one.racer !== 'me')
    const race: Race = {
      ...{ task: this.track.task, lanes, tries: this.triesOfAll, runs: this.runs },
      ...{ seed: this.seed, sameDice: this.sameDice },
    }
    // One lane alone cannot race, but it can run beside a child.
    const results = await this.#workers.run(race, (share) => (this.share = share))
    this.#workers.close()
    this.share = null
    this.#show(race, runners, criterion, results)
  }

  #show(race: Race, runners: readonly Runner[], criterion: Criterion, lanes: readonly LaneResult[]): void {
    const left = [...lanes]
    const results = runners.map((one) =>
      one.racer === 'me' ? resultOfWalk(one.tries, this.track.world) : left.shift()!,
    )
    const bills = results.map(({ bill }) => bill)
    const points = pointsOf(race.tries)
    this.last = {
      ...{ race, runners, criterion, points, results },
      ...{ winners: winnersOf(bills, criterion), order: orderOf(bills, criterion) },
    }
    this.playback.begin(points.length)
  }

  close(): void {
    this.#workers.close()
    this.playback.stop()
  }
}
