import type { Project } from '@botgarten/programs'
import { whenChangedElsewhere, type News } from '#lib/storage/channel.ts'
import { save, type Saved } from '#lib/storage/projects.ts'

/** A pause in editing after which the project is saved, in milliseconds. */
const PAUSE = 250

/** Keeps one project on the device: saves by itself, and knows when it cannot. */
export class Keeper {
  #state = $state<'saving' | 'saved' | 'failed' | 'elsewhere' | 'gone'>('saved')
  #storage = $state<'ok' | 'full' | 'refused'>('ok')
  #id = $state('')
  #revision: number
  #waiting: (() => Project) | null = null
  #timer: ReturnType<typeof setTimeout> | undefined
  #busy: Promise<void> = Promise.resolve()
  #stopListening: () => void
  /** Another tab has given the project this name. */
  whenRenamed: (name: string) => void = () => {}

  constructor(id: string, revision: number) {
    this.#id = id
    this.#revision = revision
    this.#stopListening = whenChangedElsewhere(id, (news) => this.#hear(news))
  }

  #hear(news: News): void {
    if (this.#revision === 0 && news.kind === 'gone') return
    if (news.kind === 'gone') this.#state = 'gone'
    else if (news.name !== undefined && news.revision === this.#revision + 1) {
      // Only the name is another one: both can go on.
      this.#revision = news.revision
      this.whenRenamed(news.name)
    } else if (news.revision > this.#revision) this.#state = 'elsewhere'
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
    if (this.#state === 'elsewhere' || this.#state === 'gone') return
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
    else if (outcome.kind === 'gone') this.#state = 'gone'
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
    this.#stopListening = whenChangedElsewhere(id, (news) => this.#hear(news))
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
