import { Autosave, type SaveStatus } from '#storage/autosave.ts'

/** The autosave of one project, as the screen sees it. */
export class Keeper extends Autosave {
  #seen = $state.raw<SaveStatus>({ id: '', state: 'saved', storage: 'ok', refusal: null })

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
  get state() {
    return this.#seen.state
  }
  get storage() {
    return this.#seen.storage
  }
}
