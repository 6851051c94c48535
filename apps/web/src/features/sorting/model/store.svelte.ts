import type { Project } from '@botgarten/programs'
import type { SortingDocument } from '@botgarten/programs/sorting'
import { placeOf } from '#content/cards.ts'
import { shownName } from '#content/names.ts'
import { ProjectAutosave } from '#lab/autosave.svelte.ts'
import { nameOfCopy } from '#storage/messages.ts'
import { freshId } from '#storage/projects.ts'

/** Where a playground is saved. */
export interface Store {
  /** The document as it was opened; not to be trusted. */
  readonly kept: unknown
  keep(kept: () => SortingDocument): void
  /** Saves pending changes at once. */
  flush(): void
  close(): void
}

/** A project that is opened for sorting. `revision`: 0 if it was never saved. */
export interface OpenedForSorting {
  readonly id: string
  readonly revision: number
  readonly project: Project
}

/** The project whose document holds the playground: it goes wherever the project goes. */
export class SortingProject implements Store {
  readonly kept: unknown
  readonly autosave: ProjectAutosave
  readonly #opened: Project
  #name = $state('')
  #sorting: (() => SortingDocument) | null = null

  constructor({ id, revision, project }: OpenedForSorting) {
    this.#opened = project
    this.#name = project.name
    this.kept = project.sorting ?? null
    this.autosave = new ProjectAutosave(id, revision)
    this.autosave.whenRenamed = (name) => (this.#name = name)
  }

  /** The card, `free`, or `sorting` for a project of this playground alone. */
  get place() {
    return placeOf(this.#opened)
  }
  get title() {
    return shownName({ project: { ...this.#opened, name: this.#name } })
  }
  get project(): Project {
    const sorting = this.#sorting && { sorting: this.#sorting() }
    return { ...this.#opened, name: this.#name, ...sorting }
  }
  /** The same under the name that is displayed. */
  get named(): Project {
    return { ...this.project, name: this.title }
  }

  keep(sorting: () => SortingDocument): void {
    this.#sorting = sorting
    this.autosave.changed(() => this.project)
  }

  rename(name: string): void {
    this.#name = name
    this.autosave.changed(() => this.project)
  }

  /** Another tab has changed the project: saves this one as a copy. @returns its id */
  continueAsCopy(): string {
    const id = freshId(this.place)
    this.#name = nameOfCopy(this.title, [])
    void this.autosave.continueAs(id, () => this.project)
    return id
  }

  /** Another tab has deleted the project: saves this one under a new id. */
  continueGone(): string {
    const id = freshId(this.place)
    void this.autosave.continueAs(id, () => this.project)
    return id
  }

  flush(): void {
    void this.autosave.flush()
  }

  close(): void {
    this.autosave.close()
  }
}
