import type { Project } from '@botgarten/programs'
import { save, whenSavedElsewhere, type Saved } from '#lib/storage/projects.ts'

/** A pause in editing after which the project is saved, in milliseconds. */
const PAUSE = 250

/** Keeps one project on the device: saves by itself, and knows when it cannot. */
export class Keeper {
  #state = $state<'saving' | 'saved' | 'failed' | 'elsewhere'>('saved')
  #storage = $state<'ok' | 'full' | 'refused'>('ok')
  #id = $state('')
  #revision: number
  #waiting: (() => Project) | null = null
  #timer: ReturnType<typeof setTimeout> | undefined
  #busy: Promise<void> = Promise.resolve()
  #stopListening: () => void

  constructor(id: string, revision: number) {
    this.#id = id
    this.#revision = revision
    this.#stopListening = whenSavedElsewhere(id, (theirs) => {
      if (theirs > this.#revision) this.#state = 'elsewhere'
    })
  }

  get id() {
    return this.#id
  }
  get state() {
    return this.#state
  }
  get storage() {
    return this.#storage
  }

  /** Something has changed; `project` is asked for when it is time to save. */
  changed(project: () => Project): void {
    this.#waiting = project
    if (this.#state === 'elsewhere') return
    this.#state = 'saving'
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => void this.flush(), PAUSE)
  }

  /** Tries again what has failed. */
  retry(): void {
    this.#state = 'saving'
    void this.flush()
  }

  /** Saves what waits, now: on a hidden page, before a reload. */
  flush(): Promise<void> {
    clearTimeout(this.#timer)
    this.#busy = this.#busy.then(() => this.#saveWaiting())
    return this.#busy
  }

  async #saveWaiting(): Promise<void> {
    const project = this.#waiting
    if (!project) return
    this.#waiting = null
    const outcome = await save(this.#id, project(), this.#revision)
    if (outcome.kind !== 'saved') this.#waiting ??= project
    this.#take(outcome)
  }

  #take(outcome: Saved): void {
    if (outcome.kind === 'newer') this.#state = 'elsewhere'
    else if (outcome.kind === 'saved') {
      this.#revision = outcome.revision
      this.#storage = 'ok'
      if (!this.#waiting) this.#state = 'saved'
    } else {
      this.#storage = outcome.kind
      this.#state = 'failed'
    }
  }

  /** From here on under another key: "keep mine as a copy". */
  continueAs(id: string, project: () => Project): Promise<void> {
    this.#stopListening()
    this.#id = id
    this.#revision = 0
    this.#state = 'saving'
    this.#waiting = project
    this.#stopListening = whenSavedElsewhere(id, () => (this.#state = 'elsewhere'))
    return this.flush()
  }

  /**
   * Puts what another tab's project would replace under a key of its own.
   * @returns whether nothing is lost when the other tab's project is taken now
   */
  async putAside(id: string, name: string): Promise<boolean> {
    if (!this.#waiting) return true
    const outcome = await save(id, { ...this.#waiting(), name }, 0)
    if (outcome.kind !== 'saved') return false
    this.#waiting = null
    return true
  }

  close(): void {
    this.#stopListening()
    void this.flush()
  }
}
