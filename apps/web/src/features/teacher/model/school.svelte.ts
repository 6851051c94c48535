import * as answers from './answers.ts'
import type { ClassInFull, Pupil } from './answers.ts'
import type { ClassApi } from './api.ts'
import { Attempts } from './attempts.svelte.ts'

/** One class as its teacher sees it, and what can be done with it. */
export class School {
  readonly id: string
  readonly #api: ClassApi
  #row = $state.raw<ClassInFull | null>(null)
  #pupils = $state.raw<readonly Pupil[]>([])
  readonly #attempts = new Attempts()

  constructor(api: ClassApi, id: string) {
    this.#api = api
    this.id = id
  }

  /** Null until it has been asked for. */
  get row(): ClassInFull | null {
    return this.#row
  }

  /** From A to Z. */
  get pupils(): readonly Pupil[] {
    return this.#pupils
  }

  /** Why the last request was not done; null where it was. */
  get refused(): string | null {
    return this.#attempts.refused
  }

  async load(): Promise<void> {
    await this.#attempts.try(async () => {
      const [row, { pupils }] = await Promise.all([
        this.#api.ask(answers.classInFull, 'GET', this.at('')),
        this.#api.ask(answers.pupils, 'GET', this.at('/pupils')),
      ])
      this.#row = row
      this.#pupils = pupils
    })
  }

  /** Address of something in the class. */
  at = (path: string): string => `/classes/${this.id}${path}`

  /** Newcomers can join for 20 minutes. @returns whether it was done, as all of these */
  open = () => this.#do('POST', '/open')
  /** The lesson is over. */
  close = () => this.#do('POST', '/close')
  newCode = () => this.#do('POST', '/code')
  signOutAll = () => this.#do('POST', '/sign-out-all')
  change = (change: { name?: string; grade?: number; endsOn?: string }) => this.#do('PATCH', '', change)
  rename = (pupil: string, nickname: string) => this.#do('PATCH', `/pupils/${pupil}`, { nickname })
  removePupil = (pupil: string) => this.#do('DELETE', `/pupils/${pupil}`)
  /** All nicknames that others have guessed at too often are open again. */
  unlockAll = () => this.#do('POST', '/unlock')
  handDown = (pupil: string) => this.#do('POST', `/pupils/${pupil}/hand-down`)

  /** Deletes the class with everything; `name` is what was typed. */
  deleteAll = (name: string): Promise<boolean> =>
    this.#attempts.do(() => this.#api.send('DELETE', this.at(''), { name }))

  /** Three new pictures for a pupil, shown once; null where it was refused. */
  async newPictures(pupil: string): Promise<readonly string[] | null> {
    const given = await this.#attempts.try(() =>
      this.#api.ask(answers.pictures, 'POST', this.at(`/pupils/${pupil}/pictures`)),
    )
    if (given) await this.load()
    return given?.pictures ?? null
  }

  /** Who has done which card; null where it was refused. */
  results = () => this.#attempts.try(() => this.#api.ask(answers.results, 'GET', this.at('/results')))
  /** What is kept, how much of it, and until when; null where it was refused. */
  data = () => this.#attempts.try(() => this.#api.ask(answers.data, 'GET', this.at('/data')))
  /** A link for somebody who takes the class today; null where it was refused. */
  lend = () => this.#attempts.try(() => this.#api.ask(answers.substituteLink, 'POST', this.at('/substitute')))
  /** Links that were made for others end now. */
  endLending = () => this.#do('DELETE', '/substitute')

  async #do(method: 'POST' | 'PATCH' | 'DELETE', path: string, body?: unknown): Promise<boolean> {
    const done = await this.#attempts.do(() => this.#api.send(method, this.at(path), body))
    if (done) await this.load()
    return done
  }
}
