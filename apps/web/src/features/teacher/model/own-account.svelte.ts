import { classes, teachersAnswer, type SchoolClass, type TeacherRow } from './answers.ts'
import type { ClassApi } from './api.ts'
import { Attempts } from './attempts.svelte.ts'

/** Changes and deletes the account of a teacher; the operator deletes those of others. */
export class OwnAccount {
  readonly #api: ClassApi
  readonly #reading = new Attempts()
  readonly change = new Attempts()
  readonly deletion = new Attempts()
  readonly removal = new Attempts()
  #classes = $state.raw<readonly SchoolClass[] | null>(null)
  #teachers = $state.raw<readonly TeacherRow[] | null>(null)
  #isChanged = $state(false)

  constructor(api: ClassApi) {
    this.#api = api
  }

  /** The classes of this teacher; null until they are loaded. */
  get classes(): readonly SchoolClass[] | null {
    return this.#classes
  }

  /** All teachers of the server; null for a teacher who is no operator. */
  get teachers(): readonly TeacherRow[] | null {
    return this.#teachers
  }

  /** No one else runs the server. */
  get isOnlyOperator(): boolean {
    return this.#teachers?.filter(({ operator }) => operator).length === 1
  }

  /** The password has been changed on this page. */
  get isChanged(): boolean {
    return this.#isChanged
  }

  /** The server's code; null if everything was loaded. */
  get refused(): string | null {
    return this.#reading.refused
  }

  async load(operator: boolean): Promise<void> {
    await this.#reading.do(async () => {
      this.#classes = (await this.#api.ask(classes, 'GET', '/classes')).classes
      if (operator) this.#teachers = (await this.#api.ask(teachersAnswer, 'GET', '/teachers')).teachers
    })
  }

  /** @returns whether the password was changed */
  async changePassword(password: string, newPassword: string): Promise<boolean> {
    this.#isChanged = await this.change.do(() =>
      this.#api.send('POST', '/teachers/me/password', { password, newPassword }),
    )
    return this.#isChanged
  }

  /** @returns whether the account was deleted */
  async deleteAccount(password: string): Promise<boolean> {
    const isDeleted = await this.deletion.do(() => this.#api.send('DELETE', '/teachers/me', { password }))
    // Another page of this teacher may have made a class.
    if (this.deletion.refused === 'ownsClasses') await this.load(false)
    return isDeleted
  }

  /** Deletes another teacher with all classes. @returns whether that was done */
  async deleteTeacher({ id }: TeacherRow, username: string): Promise<boolean> {
    const isDeleted = await this.removal.do(() => this.#api.send('DELETE', `/teachers/${id}`, { username }))
    if (isDeleted) await this.load(true)
    return isDeleted
  }
}
