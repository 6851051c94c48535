import { phraseAnswer } from './answers.ts'
import type { ClassApi } from './api.ts'
import { Attempts } from './attempts.svelte.ts'

/** The phrase that opens the backups: shown once for the asking, from then on for the password of the operator. */
export class BackupPhrase {
  readonly #api: ClassApi
  readonly #attempts = new Attempts()
  #words = $state.raw<string | null>(null)

  constructor(api: ClassApi) {
    this.#api = api
  }

  /** Ten words with hyphens; null while they are not shown. */
  get words(): string | null {
    return this.#words
  }

  /** It has been shown before. */
  get needsPassword(): boolean {
    return this.refused !== null && ['passwordNeeded', 'passwordWrong', 'tooManyTries'].includes(this.refused)
  }

  /** The server's code; null if the last request succeeded. */
  get refused(): string | null {
    return this.#attempts.refused
  }

  /** @param password null: to see it for the first time */
  async show(password: string | null): Promise<void> {
    const ask = () => this.#api.ask(phraseAnswer, 'POST', '/backup/phrase', { password })
    this.#words = (await this.#attempts.try(ask))?.phrase ?? null
  }

  hide(): void {
    this.#words = null
  }
}
