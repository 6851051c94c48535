import { serverState } from './answers.ts'
import { Refused, type ClassApi } from './api.ts'

/** `none`: there is no class server here. `unmade`: it waits for its first teacher. */
export type Access =
  | { readonly kind: 'asking' | 'none' | 'unmade' }
  | { readonly kind: 'out'; readonly first: { readonly name: string; readonly madeAt: number } }
  | { readonly kind: 'in'; readonly username: string; readonly operator: boolean }

/** Who sits before the teacher's pages. */
export class Account {
  readonly #api: ClassApi
  #access = $state.raw<Access>({ kind: 'asking' })
  /** Is the page read over https, or on the machine of the server? */
  #secure = $state(true)

  constructor(api: ClassApi) {
    this.#api = api
  }

  get access(): Access {
    return this.#access
  }

  get secure(): boolean {
    return this.#secure
  }

  /** Asks the server; for the start of a page, and after a session may have ended. */
  async look(): Promise<void> {
    this.#access = await this.#asked().catch((error: unknown) => {
      if (error instanceof Refused) return { kind: 'none' } as const
      throw error
    })
  }

  async #asked(): Promise<Access> {
    const { firstTeacher, secure, teacher } = await this.#api.ask(serverState, 'GET', '/state')
    this.#secure = secure
    if (teacher) return { kind: 'in', ...teacher }
    if (!firstTeacher) return { kind: 'unmade' }
    return { kind: 'out', first: { name: firstTeacher.name ?? '', madeAt: firstTeacher.madeAt } }
  }

  /** @throws Refused */
  async signIn(username: string, password: string): Promise<void> {
    await this.#api.tell('POST', '/auth/sign-in/username', { username, password })
    await this.look()
  }

  /** Signs out here, or on every device. @throws Refused */
  async signOut(everywhere: boolean): Promise<void> {
    await this.#api.tell('POST', everywhere ? '/teachers/me/end-sessions' : '/auth/sign-out')
    await this.look()
  }
}
