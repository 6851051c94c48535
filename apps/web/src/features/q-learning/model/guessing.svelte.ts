import type { QWorld } from '@botgarten/learning/q-learning'
import { nextStations, reachesGoal, tapped, type Guess } from './guess.ts'

/** The guess of a child: which way is the shortest? Taps on the map make it before Bo learns. */
export class Guessing {
  #world = $state.raw<QWorld | null>(null)
  #stations = $state.raw<Guess>([])
  /** Do taps on the map belong to the guess? */
  open = $state(false)
  /** Is the guess still to be compared with the learned way? False once the user has closed the comparison. */
  compares = $state(true)

  get stations() {
    return this.#stations
  }

  readonly isDone = $derived.by(() => this.#world !== null && reachesGoal(this.#world, this.#stations))
  /** Stations to which the guess can be continued. */
  readonly next = $derived.by(() =>
    this.open && this.#world && this.#stations.length > 0 ? nextStations(this.#world, this.#stations) : [],
  )

  /** As the table of trials keeps it: `0-1-4`; '' where nothing was guessed. */
  get text(): string {
    return this.isDone ? this.#stations.join('-') : ''
  }

  /** Deletes the guess, because the task has changed. */
  forget(): void {
    this.#stations = []
    this.open = false
  }

  begin(world: QWorld): void {
    this.#world = world
    this.#stations = [world.start]
    this.open = this.compares = true
  }

  tap(station: number): void {
    if (this.#world) this.#stations = tapped(this.#world, this.#stations, station)
  }

  undo(): void {
    if (this.#stations.length > 1) this.#stations = this.#stations.slice(0, -1)
  }

  clear(): void {
    this.#stations = this.#stations.slice(0, 1)
  }

  /** Ends guessing; a guess that does not reach the goal is deleted. */
  close(): void {
    this.open = false
    if (!this.isDone) this.#stations = []
  }
}
