import type { PaperCounts, Tally } from '@botgarten/answers'
import { writeFormFile, type LoadedForm } from '@botgarten/content/questionnaires'
import * as v from 'valibot'
import { formIn } from './class-question.ts'
import { askings, pupils, results, rows, type ClassResults } from './class-answers.ts'
import { isKnown, isOurs } from './forms.ts'
import type { JoinedGrowth, Rows, Source } from './source.ts'

/** Asks the class server about the questionnaires of a class. @throws an error whose `code` says why it did not */
export type AskClass = (method: 'GET' | 'POST' | 'DELETE', path: string, body?: unknown) => Promise<unknown>

/** A form that the class was asked. */
export interface ClassAsking {
  readonly loaded: LoadedForm
  readonly state: 'open' | 'closing' | 'closed'
  readonly seconds: number | null
  readonly came: number | null
  readonly paper: number
}

const nothing: ClassResults = { forms: [], growths: [] }

const codeOf = (error: unknown): string =>
  error instanceof Error && 'code' in error && typeof error.code === 'string' ? error.code : 'noServer'

/** What a class was asked, and what is published of its answers. */
export class ClassSheets implements Source {
  readonly #ask: AskClass
  #askings = $state.raw<readonly ClassAsking[]>([])
  #results = $state.raw<ClassResults>(nothing)
  /** Why a teacher's last action was refused; null if it was done. */
  #refused = $state<string | null>(null)
  /** Why the class could not be loaded; null if it was. */
  #unread = $state<string | null>(null)
  loaded = $state(false)

  constructor(ask: AskClass) {
    this.#ask = ask
  }

  get refused(): string | null {
    return this.#refused ?? this.#unread
  }
  get askings(): readonly ClassAsking[] {
    return this.#askings
  }
  get forms(): readonly LoadedForm[] {
    return this.#askings.map(({ loaded }) => loaded)
  }
  of = (form: string): ClassAsking | undefined => this.#askings.find(({ loaded }) => loaded.form.id === form)

  /** Is something about to change by itself: answers that come, a form that closes? */
  get isMoving(): boolean {
    return this.#askings.some(({ state }) => state !== 'closed')
  }

  isOpen = (form: string): boolean => (this.of(form)?.state ?? 'closed') !== 'closed'
  count = (form: string): number | null => this.of(form)?.came ?? (this.of(form) ? null : 0)

  tallies = ({ form }: LoadedForm): readonly Tally[] =>
    this.#results.forms.find((one) => one.form === form.id)?.tallies ?? []

  growths(forms: readonly LoadedForm[]): readonly JoinedGrowth[] {
    const named = (id: string) => forms.find(({ form }) => form.id === id)
    return this.#results.growths.flatMap(({ before: one, after: other, growth }): JoinedGrowth[] => {
      const [before, after] = [named(one), named(other)]
      return before && after ? [{ before, after, growth }] : []
    })
  }

  async rows({ form }: LoadedForm): Promise<Rows> {
    return v.parse(rows, await this.#ask('GET', `/questionnaires/${form.id}/rows`)).rows
  }

  async load(): Promise<void> {
    this.#unread = await codeOfFailure(async () => {
      const found = v.parse(askings, await this.#ask('GET', '/questionnaires'))
      this.#askings = found.askings
        .map(({ form, text, ...rest }) => ({ ...rest, loaded: formIn({ form, text }) }))
        .filter(({ loaded }) => isKnown(loaded))
      this.#results = v.parse(results, await this.#ask('GET', '/questionnaires/results'))
      this.loaded = true
    })
  }

  /** Asks the class a form, also once more. */
  async open(loaded: LoadedForm): Promise<void> {
    const asked = isOurs(loaded.form.id)
      ? { form: loaded.form.id }
      : { own: JSON.parse(writeFormFile(loaded)) as unknown }
    await this.#do(() => this.#ask('POST', '/questionnaires', asked))
  }

  close(form: string): void {
    void this.#do(() => this.#ask('POST', `/questionnaires/${form}/close`))
  }

  async addPaper({ form, ...counts }: PaperCounts): Promise<void> {
    await this.#do(() => this.#ask('POST', `/questionnaires/${form}/paper`, counts))
  }

  /** Pupils of the class; none if the class cannot be reached. */
  async pupils(): Promise<readonly { readonly id: string; readonly nickname: string }[]> {
    try {
      return v.parse(pupils, await this.#ask('GET', '/pupils')).pupils
    } catch {
      return []
    }
  }

  /** Allows a pupil a second token for an open form. `before`: it was allowed already. */
  async allowAgain(form: string, pupil: string): Promise<'allowed' | 'before' | 'failed'> {
    try {
      await this.#ask('POST', `/questionnaires/${form}/again`, { pupil })
      return 'allowed'
    } catch (error) {
      return codeOf(error) === 'onceAgainOnly' ? 'before' : 'failed'
    }
  }

  async removePaper(form: string): Promise<void> {
    await this.#do(() => this.#ask('DELETE', `/questionnaires/${form}/paper`))
  }

  async #do(act: () => Promise<unknown>): Promise<void> {
    this.#refused = await codeOfFailure(act)
    if (this.#refused === null) await this.load()
  }
}

/** Code of the error that an action ends with; null: it succeeds. */
async function codeOfFailure(act: () => Promise<unknown>): Promise<string | null> {
  try {
    await act()
    return null
  } catch (error) {
    return codeOf(error)
  }
}
