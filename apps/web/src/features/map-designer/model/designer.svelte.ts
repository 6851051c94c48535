import { faultsOf, lineOf, reachOf } from '@botgarten/maps/own'
import type { RoadMap } from '@botgarten/programs'
import { refusalOf } from '@botgarten/programs/project'
import { DrawnMap } from './drawn.svelte.ts'
import type { OpenedDrawing } from './projects.ts'
import { RoadTries } from './tries.svelte.ts'

export const tools = ['station', 'road', 'sign', 'reward'] as const
export type Tool = (typeof tools)[number]

/** What is opened beside the map. */
export type Chosen =
  | { readonly kind: 'station'; readonly index: number }
  | { readonly kind: 'road'; readonly index: number }
  | null

/** One map being drawn: the document, its past, what is chosen, and what is said of it. */
export class Designer extends DrawnMap<RoadMap> {
  readonly tries = new RoadTries()
  /** What stands there while a hand pulls. */
  #pulled = $state.raw<RoadMap | null>(null)
  tool = $state<Tool>('station')
  chosen = $state.raw<Chosen>(null)

  constructor(opened: OpenedDrawing) {
    super(opened, opened.project.maps![opened.mapId] as RoadMap)
    this.tries.follow(this.settled)
  }

  /** As it is seen now, in the middle of a pull too; `settled`: without it, so that scenery does not jump under a hand. */
  get map() {
    return this.#pulled ?? this.settled
  }

  readonly lines = $derived(this.map.roads.map((road) => lineOf(this.map, road)))
  readonly faults = $derived(faultsOf(this.map))
  /** A pull moves things; which roads there are it leaves alone. */
  readonly reach = $derived(reachOf(this.settled))

  override change(next: RoadMap): void {
    this.#pulled = null
    super.change(next)
  }

  /** In the middle of a pull. */
  pull(next: RoadMap): void {
    this.#pulled = next
  }

  /** The hand lets go: one step, from before it pulled. */
  drop(): void {
    if (this.#pulled) this.change(this.#pulled)
  }

  protected override changed(map: RoadMap): void {
    const { chosen } = this
    const count = chosen?.kind === 'station' ? map.stations.length : map.roads.length
    if (chosen && chosen.index >= count) this.chosen = null
    this.tries.follow(map)
  }

  /** A photo under the roads. Returns why it cannot be: the project would be larger than any may be. */
  layPhoto(photo: string): 'room' | null {
    const map: RoadMap = { ...this.settled, dress: 'photo', photo }
    if (refusalOf(this.with(map)) !== null) return 'room'
    this.change(map)
    return null
  }

  override close(): void {
    super.close()
    this.tries.close()
  }
}
