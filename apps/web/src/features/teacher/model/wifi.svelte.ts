import { wifiAnswer, type Wifi } from './answers.ts'
import type { ClassApi } from './api.ts'
import { Attempts } from './attempts.svelte.ts'

/** Can a Wi-Fi be called so, and opened by that? As IEEE 802.11 has it; an open one has no password. */
export const isWifi = ({ name, password }: Wifi): boolean =>
  name.trim() !== '' &&
  new TextEncoder().encode(name.trim()).length <= 32 &&
  /^([\x20-\x7e]{8,63})?$/.test(password)

/** The Wi-Fi of the room, as a teacher's classes show it on the projector page. */
export class RoomWifi {
  readonly #api: ClassApi
  readonly #path: string
  readonly #attempts = new Attempts()
  #found = $state.raw<Wifi | null>(null)

  constructor(api: ClassApi, classId: string) {
    this.#api = api
    this.#path = `/classes/${classId}/wifi`
  }

  /** Null until it is loaded, and where none was named. */
  get found(): Wifi | null {
    return this.#found
  }

  get refused(): string | null {
    return this.#attempts.refused
  }

  async load(): Promise<void> {
    const answer = await this.#attempts.try(() => this.#api.ask(wifiAnswer, 'GET', this.#path))
    if (answer) this.#found = answer.wifi
  }

  /** @returns whether the server has it */
  async save({ name, password }: Wifi): Promise<boolean> {
    const wifi = { name: name.trim(), password }
    const isSaved = await this.#attempts.do(() => this.#api.send('PUT', this.#path, wifi))
    if (isSaved) this.#found = wifi
    return isSaved
  }

  /** @returns whether the server has none any more */
  async remove(): Promise<boolean> {
    const isGone = await this.#attempts.do(() => this.#api.send('DELETE', this.#path))
    if (isGone) this.#found = null
    return isGone
  }
}
