import { faultsOf, lineOf, reachOf, setStation, type Changed } from '@botgarten/maps/own'
import type { MapDocument } from '@botgarten/programs'
import { refusalOf } from '@botgarten/programs/project'
import { ProjectAutosave } from '#lab/autosave.svelte.ts'
import { learningOn, withMap, type OpenedDrawing } from './projects.ts'
import { RoadTries } from './tries.svelte.ts'

export const tools = ['station', 'road', 'sign', 'reward'] as const
export type Tool = (typeof tools)[number]

/** What is opened beside the map. */
export type Chosen =
  | { readonly kind: 'station'; readonly index: number }
  | { readonly kind: 'road'; readonly index: number }
  | null

/** Steps that can be taken back. */
const MOST = 200

/** One map being drawn: the document, its past, what is chosen, and what is said of it. */
export class Designer {
  readonly autosave: ProjectAutosave
  readonly tries = new RoadTries()
  readonly #opened: OpenedDrawing
  #map = $state.raw<MapDocument>(undefined as never)
  /** What stands there while a hand pulls. */
  #pulled = $state.raw<MapDocument | null>(null)
  #past = $state.raw<readonly MapDocument[]>([])
  #future = $state.raw<readonly MapDocument[]>([])
  tool = $state<Tool>('station')
  chosen = $state.raw<Chosen>(null)

  constructor(opened: OpenedDrawing) {
    this.#opened = opened
    this.#map = opened.project.maps![opened.mapId]!
    this.autosave = new ProjectAutosave(opened.id, opened.revision)
    this.tries.follow(this.#map)
  }

  /** As it is seen now, in the middle of a pull too. */
  get map() {
    return this.#pulled ?? this.#map
  }
  /** Without the pull: scenery does not jump under a hand. */
  get settled() {
    return this.#map
  }
  get canUndo() {
    return this.#past.length > 0
  }
  get canRedo() {
    return this.#future.length > 0
  }
  get id() {
    return this.#opened.id
  }
  get mapId() {
    return this.#opened.mapId
  }
  /** A project that holds nothing but this map is called like it. */
  get project() {
    const project = withMap(this.#opened.project, this.#opened.mapId, this.#map)
    const alone = project.card === undefined && Object.keys(project.maps!).length === 1
    return alone && this.#map.name.trim() !== '' ? { ...project, name: this.#map.name.trim() } : project
  }

  /** The project, whose programs learn on this map. */
  get learning() {
    return learningOn(this.project, this.mapId)
  }

  readonly lines = $derived(this.map.roads.map((road) => lineOf(this.map, road)))
  readonly faults = $derived(faultsOf(this.map))
  readonly reach = $derived(reachOf(this.map))

  /** One step. What changes nothing is none. */
  change(next: MapDocument): void {
    this.#pulled = null
    if (next === this.#map) return
    this.#past = [...this.#past.slice(1 - MOST), this.#map]
    this.#future = []
    this.#set(next)
  }

  /** In the middle of a pull. */
  pull(next: MapDocument): void {
    this.#pulled = next
  }

  /** The hand lets go: one step, from before it pulled. */
  drop(): void {
    if (this.#pulled) this.change(this.#pulled)
  }

  undo(): void {
    const before = this.#past.at(-1)
    if (!before) return
    this.#past = this.#past.slice(0, -1)
    this.#future = [...this.#future, this.#map]
    this.#set(before)
  }

  redo(): void {
    const next = this.#future.at(-1)
    if (!next) return
    this.#future = this.#future.slice(0, -1)
    this.#past = [...this.#past, this.#map]
    this.#set(next)
  }

  #set(map: MapDocument): void {
    this.#map = map
    const { chosen } = this
    const count = chosen?.kind === 'station' ? map.stations.length : map.roads.length
    if (chosen && chosen.index >= count) this.chosen = null
    this.tries.follow(map)
    this.autosave.changed(() => this.project)
  }

  nameStation(station: number, change: Changed<MapDocument['stations'][number]>): void {
    this.change(setStation(this.#map, station, change))
  }

  /** A photo under the roads. Returns why it cannot be: the project would be larger than any may be. */
  layPhoto(photo: string): 'room' | null {
    const map: MapDocument = { ...this.#map, dress: 'photo', photo }
    if (refusalOf(withMap(this.#opened.project, this.#opened.mapId, map)) !== null) return 'room'
    this.change(map)
    return null
  }

  /** The program learns on this map. Resolves when that is saved. */
  async learnHere(): Promise<boolean> {
    const project = this.learning
    this.autosave.changed(() => project)
    await this.autosave.flush()
    return this.autosave.state === 'saved'
  }

  close(): void {
    this.autosave.close()
    this.tries.close()
  }
}
