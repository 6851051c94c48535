import { codeOf } from './api.ts'

/** Requests to the class server, and why it refused the last one. */
export class Attempts {
  #refused = $state<string | null>(null)

  /** The server's code; null where the last request was done. */
  get refused(): string | null {
    return this.#refused
  }

  /** @returns null where the server refused */
  async try<Result>(request: () => Promise<Result>): Promise<Result | null> {
    try {
      const result = await request()
      this.#refused = null
      return result
    } catch (error) {
      this.#refused = codeOf(error)
      return null
    }
  }

  /** @returns whether it was done */
  async do(request: () => Promise<unknown>): Promise<boolean> {
    return (await this.try(async () => (await request(), true))) === true
  }
}
