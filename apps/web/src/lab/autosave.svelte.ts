import type { Project } from '@botgarten/programs'
import { Autosave, type SaveStatus } from '#storage/autosave.ts'
import type { LabEvent } from './change.ts'

/** The autosave of one project, as the screen sees it. */
export class ProjectAutosave extends Autosave {
  #seen = $state.raw<SaveStatus>({ id: '', revision: 0, state: 'saved', storage: 'ok', refusal: null })

  constructor(id: string, revision: number) {
    super(id, revision, (status) => (this.#seen = status))
    this.#seen = super.status
  }

  override get status(): SaveStatus {
    return this.#seen
  }
  get id() {
    return this.#seen.id
  }
  get revision() {
    return this.#seen.revision
  }
  get state() {
    return this.#seen.state
  }
  get storage() {
    return this.#seen.storage
  }
}

/** Listens to a session for its autosave. */
export const savesTo =
  (autosave: Autosave, project: () => Project) =>
  (event: LabEvent): void => {
    // A step of the blocks is told once more by the program that they then say.
    if (event.kind === 'branched' || (event.kind === 'changed' && event.change.kind !== 'blocks'))
      autosave.changed(project)
  }
