import { serverState, substituteOf } from './answers.ts'
import { Refused, type ClassApi } from './api.ts'

/** `none`: there is no class server here. `unmade`: it waits for its first teacher. */
export type Access =
  | { readonly kind: 'asking' | 'none' | 'unmade' }
  /** Somebody with a link to one class, until midnight. */
  | { readonly kind: 'substitute'; readonly class: string; readonly name: string }
  /** Signed out. `madeAt`: time of the first account, ms since 1970. */
  | { readonly kind: 'out'; readonly madeAt: number }
  | { readonly kind: 'in'; readonly username: string; readonly operator: boolean }

/** Who sits before the teacher's pages. */
export class Account {
  readonly #api: ClassApi
  #access = $state.raw<Access>({ kind: 'asking' })
  /** Is the page read over https, or on the machine of the server? */
  #secure = $state(true)
  #address = $state<string | null>(null)

  constructor(api: ClassApi) {
    this.#api = api
  }

  get access(): Access {
    return this.#access
  }

  /** May this teacher invite others, and back up? */
  get operates(): boolean {
    return this.#access.kind === 'in' && this.#access.operator
  }

  get secure(): boolean {
    return this.#secure
  }

  /** The address that the server announces; null: not known. */
  get address(): string | null {
    return this.#address
  }

  /** Asks the server; for the start of a page, and after a session may have ended. */
  async look(): Promise<void> {
    this.#access = await this.#asked().catch((error: unknown) => {
      if (error instanceof Refused) return { kind: 'none' } as const
      throw error
    })
  }

  async #asked(): Promise<Access> {
    const state = await this.#api.ask(serverState, 'GET', '/state')
    const { firstTeacher, secure, teacher, substitute, address } = state
    this.#secure = secure
    this.#address = address
    if (teacher) return { kind: 'in', ...teacher }
    if (substitute) return { kind: 'substitute', ...substitute }
    if (!firstTeacher) return { kind: 'unmade' }
    return { kind: 'out', madeAt: firstTeacher.madeAt }
  }

  /** @throws Refused */
  async signIn(username: string, password: string): Promise<void> {
    await this.#api.send('POST', '/auth/sign-in/username', { username, password })
    await this.look()
  }

  /** Takes the class of a link for today. @returns the id of the class @throws Refused */
  async substitute(token: string): Promise<string> {
    const { id } = await this.#api.ask(substituteOf, 'POST', '/substitute', { token })
    await this.look()
    return id
  }

  /** Signs out here, or on every device. @throws Refused */
  async signOut(everywhere: boolean): Promise<void> {
    if (this.#access.kind === 'substitute') await this.#api.send('POST', '/substitute/leave')
    else await this.#api.send('POST', everywhere ? '/teachers/me/end-sessions' : '/auth/sign-out')
    await this.look()
  }
}
