import type { Project, ProjectError } from '@botgarten/programs'
import { whenChangedElsewhere, type News } from './channel.ts'
import type { StorageError } from './database.ts'
import { save, type Saved } from './projects.ts'

/** A pause in editing after which the project is saved, in milliseconds. */
export const PAUSE = 250
/** While a hand goes on without a pause it is saved so often all the same, in milliseconds. */
export const LONGEST = 500
/** Longest time between learning something in a run and saving it, in milliseconds. */
export const LEARNED = 5_000
/** So long after a save that failed it is tried again, in milliseconds. */
export const AGAIN = 10_000

export interface SaveStatus {
  readonly id: string
  /** Of the project on this device; 0: it was never saved. */
  readonly revision: number
  /** `elsewhere`: another tab has saved this project · `gone`: another tab has thrown it away. */
  readonly state: 'saving' | 'saved' | 'failed' | 'elsewhere' | 'gone'
  /** Why nothing can be saved. `tooMuch`: it could not be opened again; `refusal` says what is too much. */
  readonly storage: 'ok' | 'tooMuch' | StorageError
  readonly refusal: ProjectError | null
}

/** Where the project is saved. A save that began for one place says nothing about another. */
interface Place {
  readonly id: string
  revision: number
}

type GetProject = () => Project

/** Saves one project by itself, and knows when it cannot. */
export class Autosave {
  #status: SaveStatus
  #place: Place
  #waiting: GetProject | null = null
  #pause: ReturnType<typeof setTimeout> | undefined
  #limit: ReturnType<typeof setTimeout> | undefined
  #again: ReturnType<typeof setTimeout> | undefined
  #learned: ReturnType<typeof setTimeout> | undefined
  #busy: Promise<void> = Promise.resolve()
  #closed = false
  #stopListening: () => void
  readonly #report: (status: SaveStatus) => void
  /** Another tab has given the project this name. */
  whenRenamed: (name: string) => void = () => {}

  /** @param report is called with every new status */
  constructor(id: string, revision: number, report: (status: SaveStatus) => void) {
    this.#place = { id, revision }
    this.#status = { id, revision, state: 'saved', storage: 'ok', refusal: null }
    this.#report = report
    this.#stopListening = whenChangedElsewhere(id, (news) => this.#hear(news))
  }

  get status(): SaveStatus {
    return this.#status
  }

  #set(status: Partial<SaveStatus>): void {
    this.#status = { ...this.#status, ...status, revision: this.#place.revision }
    this.#report(this.#status)
  }

  #hear(news: News): void {
    const { revision } = this.#place
    if (news.kind === 'gone') {
      if (revision > 0) this.#set({ state: 'gone' })
    } else if (news.name !== undefined && news.revision === revision + 1) {
      // Only the name is another one: both can go on.
      this.#place.revision = news.revision
      this.#set({})
      this.whenRenamed(news.name)
    } else if (news.revision > revision) this.#set({ state: 'elsewhere' })
  }

  get #isTaken(): boolean {
    return this.#status.state === 'elsewhere' || this.#status.state === 'gone'
  }

  /** Something has changed; `project` is asked for when it is time to save. */
  changed(project: GetProject): void {
    this.#waiting = project
    if (this.#isTaken) return
    this.#set({ state: 'saving' })
    clearTimeout(this.#pause)
    this.#pause = setTimeout(() => void this.flush(), PAUSE)
    this.#limit ??= setTimeout(() => void this.flush(), LONGEST)
  }

  /**
   * A run has learned something. It is saved after `LEARNED`, with the next change, or when the page is hidden; the status
   * speaks of changes by hand, so it stays.
   */
  learned(project: GetProject): void {
    if (this.#isTaken) return
    this.#waiting ??= project
    this.#learned ??= setTimeout(() => void this.flush(), LEARNED)
  }

  /** Tries again what has failed. */
  retry(): void {
    this.#set({ state: 'saving' })
    void this.flush()
  }

  /** Saves what waits, now: on a hidden page, before a reload. */
  flush(): Promise<void> {
    this.#stopClocks()
    this.#busy = this.#busy.then(() => this.#saveWaiting())
    return this.#busy
  }

  #stopClocks(): void {
    clearTimeout(this.#pause)
    clearTimeout(this.#limit)
    clearTimeout(this.#again)
    clearTimeout(this.#learned)
    this.#limit = this.#learned = undefined
  }

  async #saveWaiting(): Promise<void> {
    const project = this.#waiting
    const place = this.#place
    if (!project) return
    this.#waiting = null
    const outcome = await saved(place.id, project, place.revision)
    if (outcome.kind === 'saved') place.revision = outcome.revision
    // Meanwhile the project goes on somewhere else, and is saved there.
    if (place !== this.#place) return
    if (outcome.kind !== 'saved') this.#waiting ??= project
    this.#take(outcome)
  }

  #take(outcome: Saved): void {
    if (outcome.kind === 'newer') this.#set({ state: 'elsewhere' })
    else if (outcome.kind === 'gone') this.#set({ state: 'gone' })
    else if (outcome.kind === 'saved') {
      const state = this.#waiting || this.#isTaken ? this.#status.state : 'saved'
      this.#set({ state, storage: 'ok', refusal: null })
    } else if (outcome.kind === 'tooMuch')
      this.#set({ state: 'failed', storage: 'tooMuch', refusal: outcome.refusal })
    else {
      this.#set({ state: 'failed', storage: outcome.kind, refusal: null })
      if (!this.#closed) this.#again = setTimeout(() => void this.flush(), AGAIN)
    }
  }

  /** From here on under another key: "keep mine as a copy". */
  continueAs(id: string, project: GetProject): Promise<void> {
    this.#stopListening()
    this.#place = { id, revision: 0 }
    this.#waiting = project
    this.#set({ id, state: 'saving' })
    this.#stopListening = whenChangedElsewhere(id, (news) => this.#hear(news))
    return this.flush()
  }

  /**
   * Puts what another tab's project would replace under a key of its own.
   * @returns whether nothing is lost when the other tab's project is taken now
   */
  async putAside(id: string, name: string): Promise<boolean> {
    const project = this.#waiting
    if (!project) return true
    const outcome = await saved(id, () => ({ ...project(), name }), 0)
    if (outcome.kind !== 'saved') return false
    this.#waiting = null
    return true
  }

  close(): void {
    this.#closed = true
    this.#stopListening()
    void this.flush()
  }
}

/** A fault of ours keeps no later save from happening. */
async function saved(id: string, project: GetProject, basedOn: number): Promise<Saved> {
  try {
    return await save(id, project(), basedOn)
  } catch (cause) {
    console.error('A project could not be saved.', cause)
    return { kind: 'refused' }
  }
}
