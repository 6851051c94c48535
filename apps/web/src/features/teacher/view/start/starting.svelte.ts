import { Account } from '../../model/account.svelte.ts'
import { backedUp, classInFull, health, type ClassInFull, type Health } from '../../model/answers.ts'
import type { ClassApi } from '../../model/api.ts'
import { Attempts } from '../../model/attempts.svelte.ts'

/** How far a first start has come. */
export class Starting {
  readonly account: Account
  readonly #api: ClassApi
  #school = $state.raw<ClassInFull | null>(null)
  #health = $state.raw<Health | null>(null)
  #here = $state(0)
  #saved = $state(false)
  readonly #attempts = new Attempts()

  constructor(api: ClassApi) {
    this.#api = api
    this.account = new Account(api)
  }

  /** Empty until the account is made. */
  get username(): string {
    const { access } = this.account
    return access.kind === 'in' ? access.username : ''
  }

  get school() {
    return this.#school
  }

  get health() {
    return this.#health
  }

  /** When health was asked, by this device's clock. */
  get here() {
    return this.#here
  }

  get saved() {
    return this.#saved
  }

  get refused() {
    return this.#attempts.refused
  }

  /** Who was invited does not back up: that is for who runs the server. */
  get steps(): number {
    return this.username !== '' && !this.account.operates ? 3 : 4
  }

  /** The step to do: 1 account, 2 class, 3 backup, 4 lesson. */
  get now(): number {
    if (this.username === '') return 1
    if (!this.#school) return 2
    return this.#saved || this.steps === 3 ? 4 : 3
  }

  async look(): Promise<void> {
    await this.account.look()
    if (this.username !== '') await this.#askHealth()
  }

  async takeClass(id: string): Promise<void> {
    this.#school = await this.#api.ask(classInFull, 'GET', `/classes/${id}`)
    await this.#askHealth()
  }

  async backUp(): Promise<void> {
    await this.#attempts.do(async () => {
      await this.#api.ask(backedUp, 'POST', '/backup')
      this.#saved = true
      await this.#askHealth()
    })
  }

  /** A server with a database of its own is backed up by that one's tools. */
  skipBackUp(): void {
    this.#saved = true
  }

  async #askHealth(): Promise<void> {
    this.#health = await this.#api.ask(health, 'GET', '/health')
    this.#here = Date.now()
  }
}
