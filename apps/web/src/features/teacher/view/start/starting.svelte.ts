import { Account } from '../../model/account.svelte.ts'
import { backedUp, classes, classInFull, health, type ClassInFull, type Health } from '../../model/answers.ts'
import { Refused, type ClassApi } from '../../model/api.ts'
import { Attempts } from '../../model/attempts.svelte.ts'
import { BackupPhrase } from '../../model/backup-phrase.svelte.ts'
import { RoomWifi } from '../../model/wifi.svelte.ts'
import { Rehearsal } from '../../model/rehearsal.svelte.ts'

/** In ms: so often the health of the server is asked again. */
const healthEvery = 5000

export type StepState = 'done' | 'now' | 'next'

/** How far a first start has come. */
export class Starting {
  readonly account: Account
  readonly rehearsal: Rehearsal
  readonly phrase: BackupPhrase
  readonly #api: ClassApi
  #school = $state.raw<ClassInFull | null>(null)
  #health = $state.raw<Health | null>(null)
  #here = $state(0)
  #wifi = $state.raw<RoomWifi | null>(null)
  #withoutWifi = $state(false)
  #withoutRehearsal = $state(false)
  #saved = $state(false)
  readonly #attempts = new Attempts()

  constructor(api: ClassApi) {
    this.#api = api
    this.account = new Account(api)
    this.rehearsal = new Rehearsal(api)
    this.phrase = new BackupPhrase(api)
  }

  /** Empty until the account is made. */
  get username(): string {
    const { access } = this.account
    return access.kind === 'in' ? access.username : ''
  }

  get school() {
    return this.#school
  }

  /** Null until there is a class that shows it. */
  get wifi() {
    return this.#wifi
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

  /** Who was invited neither rehearses nor backs up: that is for who runs the server. */
  get steps(): 3 | 5 {
    return this.username !== '' && !this.account.operates ? 3 : 5
  }

  /** The step to do: 1 account, 2 class, 3 Wi-Fi, 4 rehearsal, 5 backup, 6 lesson. */
  get now(): number {
    if (this.username === '') return 1
    if (!this.#school) return 2
    if (!this.#wifi?.found && !this.#withoutWifi) return 3
    if (this.steps === 3) return 6
    if (this.rehearsal.state !== 'green' && !this.#withoutRehearsal) return 4
    return this.#saved ? 6 : 5
  }

  async look(): Promise<void> {
    await this.account.look()
    if (this.username === '') return
    await this.#askHealth()
    // A page that is loaded again goes on with the class that was made.
    const made = (await this.#api.ask(classes, 'GET', '/classes')).classes.at(-1)
    if (made) await this.takeClass(made.id)
  }

  /** Keeps the health of the server as it is now. Returns how to stop, with a rehearsal that is on. */
  watch(): () => void {
    const timer = setInterval(() => {
      if (this.username !== '') void this.#askHealth().catch(quiet)
    }, healthEvery)
    return () => (clearInterval(timer), this.rehearsal.stop())
  }

  skipWifi(): void {
    this.#withoutWifi = true
  }

  skipRehearsal(): void {
    this.#withoutRehearsal = true
  }

  async takeClass(id: string): Promise<void> {
    const wifi = new RoomWifi(this.#api, id)
    await wifi.load()
    this.#wifi = wifi
    this.#school = await this.#api.ask(classInFull, 'GET', `/classes/${id}`)
    await this.#askHealth()
  }

  /** Makes the backup, then shows the phrase; where it was shown before, the step is done. */
  async backUp(): Promise<void> {
    await this.#attempts.do(async () => {
      await this.#api.ask(backedUp, 'POST', '/backup')
      await this.phrase.show(null)
      if (this.phrase.words === null) this.#saved = true
      await this.#askHealth()
    })
  }

  /** The phrase is on paper. */
  phraseWritten(): void {
    this.phrase.hide()
    this.#saved = true
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

/** What the server does not say now it says the next time. */
function quiet(error: unknown): void {
  if (!(error instanceof Refused)) throw error
}
