import type { MapDocument, Project } from '@botgarten/programs'
import { ProjectAutosave } from '#lab/autosave.svelte.ts'
import { learningOn, withMap, type OpenedDrawing } from './projects.ts'

/** Steps that can be taken back. */
const MOST = 200

/** A map that is being drawn: the document, its past, and the project that saves it. */
export class DrawnMap<Map extends MapDocument> {
  readonly autosave: ProjectAutosave
  readonly #opened: OpenedDrawing
  #map = $state.raw<Map>(undefined as never)
  #past = $state.raw<readonly Map[]>([])
  #future = $state.raw<readonly Map[]>([])

  /** @param map that of the opened ones */
  constructor(opened: OpenedDrawing, map: Map) {
    this.#opened = opened
    this.#map = map
    this.autosave = new ProjectAutosave(opened.id, opened.revision)
  }

  /** As it is saved. */
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
    return this.with(this.#map)
  }
  /** The project, whose programs learn on this map. */
  get learning() {
    return learningOn(this.project, this.mapId)
  }

  /** The project as it would be with another map in its place. */
  protected with(map: Map): Project {
    const project = withMap(this.#opened.project, this.#opened.mapId, map)
    const alone = project.card === undefined && Object.keys(project.maps!).length === 1
    return alone && map.name.trim() !== '' ? { ...project, name: map.name.trim() } : project
  }

  /** One step. What changes nothing is none. */
  change(next: Map): void {
    if (next === this.#map) return
    this.#past = [...this.#past.slice(1 - MOST), this.#map]
    this.#future = []
    this.#set(next)
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

  #set(map: Map): void {
    this.#map = map
    this.changed(map)
    this.autosave.changed(() => this.project)
  }

  rename(name: string): void {
    this.change({ ...this.#map, name })
  }

  /** Called after every step, there and back. */
  protected changed(_map: Map): void {}

  /** The program learns on this map. Resolves when that is saved. */
  async learnHere(): Promise<boolean> {
    const project = this.learning
    this.autosave.changed(() => project)
    await this.autosave.flush()
    return this.autosave.state === 'saved'
  }

  close(): void {
    this.autosave.close()
  }
}
