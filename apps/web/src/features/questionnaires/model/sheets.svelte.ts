import {
  growthOf,
  merged,
  mixed,
  nothingReleased,
  readAnswersFile,
  released,
  rowsOf,
  shuffled,
  talliesOf,
  writeAnswersFile,
  type Answer,
  type PaperCounts,
  type Tally,
} from '@botgarten/answers'
import { readFormFile, type LoadedForm } from '@botgarten/content/questionnaires'
import { today } from './day.ts'
import { allForms, columnsIn, isKnown, isOurs } from './forms.ts'
import type { JoinedGrowth, Rows, Source } from './source.ts'
import { readKept, writeKept, type Kept } from '#storage/questionnaires.ts'
import { newAnswerId, secretChance } from '#storage/waiting-answers.ts'

/** The order of answers is a secret. */
export const chance = secretChance

/** What a child has chosen. */
export type Values = Answer['values']

/** What became of a file: so many answers or a form are new here, or it is none of ours. */
export type Taken =
  { readonly kind: 'answers'; readonly count: number } | { readonly kind: 'form' | 'refused' }

/** Every answer that this device holds, and what is asked on it. */
export class Sheets implements Source {
  #kept = $state.raw<Kept>(readKept())
  /** The device has kept the last change. */
  saved = $state(true)

  get answers(): readonly Answer[] {
    return this.#kept.answers
  }
  get release() {
    return this.#kept.release
  }
  get paper(): readonly PaperCounts[] {
    return this.#kept.paper
  }
  get asking() {
    return this.#kept.asking
  }
  get forms(): readonly LoadedForm[] {
    return allForms(this.#kept.forms).filter(isKnown)
  }
  form = (id: string | null): LoadedForm | undefined => this.forms.find((one) => one.form.id === id)

  isOpen = (form: string): boolean => this.asking?.form === form

  tallies = (loaded: LoadedForm): readonly Tally[] =>
    talliesOf(loaded.form.id, columnsIn(loaded), this).map((tally) => mixed(tally, chance))

  rows(loaded: LoadedForm): Promise<Rows> {
    const columns = columnsIn(loaded)
    return Promise.resolve(rowsOf(loaded.form.id, columns, this.tallies(loaded), this, chance))
  }

  growths(forms: readonly LoadedForm[]): readonly JoinedGrowth[] {
    const named = (id: string) => forms.find(({ form }) => form.id === id)
    return this.release.comparisons.flatMap((one): JoinedGrowth[] => {
      const [before, after] = [named(one.before), named(one.after)]
      const growth = before && after && growthOf(one, columnsIn(before), columnsIn(after), this.answers)
      return growth ? [{ before, after, growth }] : []
    })
  }

  /** Another tab may have written since. */
  #change(make: (kept: Kept) => Partial<Kept>): void {
    const before = readKept()
    const next = { ...before, ...make(before) }
    this.saved = writeKept(next)
    this.#kept = next
  }

  /** So many answered a form here or on paper; never told where they are fewer than five. */
  count(form: string): number {
    return this.answers.filter((one) => one.form === form).length + this.typed(form)
  }

  /** So many sheets of paper were typed in. */
  typed = (form: string): number =>
    this.paper.filter((one) => one.form === form).reduce((sum, { n }) => sum + n, 0)

  /** Has somebody answered this form under this code? */
  isTaken = (form: string, code: string): boolean =>
    this.answers.some((one) => one.form === form && one.code === code)

  ask(form: string, grade: number): void {
    this.#change(() => ({ asking: { form, grade } }))
  }

  /** Takes what a child has answered, in a random place among the others. */
  take(form: string, grade: number, code: string | null, values: Values): void {
    const answer: Answer = { id: newAnswerId(), form, grade, code, day: today(), values }
    this.#change(({ answers }) => ({ answers: shuffled([...answers, answer], chance) }))
  }

  /** Nobody answers any more: what may be shown is. */
  close(): void {
    this.#change((kept) => ({ asking: null, ...this.#releasing({ ...kept, asking: null }) }))
  }

  #releasing(kept: Kept): Pick<Kept, 'release'> {
    const ids = allForms(kept.forms).map(({ form }) => form.id)
    const closed = ids.filter((id) => id !== kept.asking?.form)
    return { release: released(kept.release, kept.answers, closed, chance) }
  }

  addPaper(counts: PaperCounts): void {
    this.#change(({ paper }) => ({ paper: [...paper, counts] }))
  }

  removePaper(form: string): void {
    this.#change(({ paper }) => ({ paper: paper.filter((one) => one.form !== form) }))
  }

  /** The file of all answers. */
  file = (): string => writeAnswersFile(this.answers, chance)

  /** Takes what is in a file: answers from another device, or a form. */
  takeFile(text: string): Taken {
    try {
      const json = JSON.parse(text) as { readonly botgarten?: unknown }
      return json.botgarten === 'form'
        ? this.#takeForm(readFormFile(json))
        : this.#takeAnswers(readAnswersFile(json))
    } catch {
      return { kind: 'refused' }
    }
  }

  #takeAnswers(more: readonly Answer[]): Taken {
    const before = this.answers.length
    this.#change((kept) => {
      const answers = shuffled(merged(kept.answers, more), chance)
      return { answers, ...this.#releasing({ ...kept, answers }) }
    })
    return { kind: 'answers', count: this.answers.length - before }
  }

  #takeForm(loaded: LoadedForm): Taken {
    if (isOurs(loaded.form.id) || !isKnown(loaded)) return { kind: 'refused' }
    this.keepForm(loaded)
    return { kind: 'form' }
  }

  /** Keeps a form that was changed here, in place of the one of its name. */
  keepForm(loaded: LoadedForm): void {
    this.#change(({ forms }) => ({
      forms: [...forms.filter(({ form }) => form.id !== loaded.form.id), loaded],
    }))
  }

  removeForm(id: string): void {
    this.#change(({ forms }) => ({ forms: forms.filter(({ form }) => form.id !== id) }))
  }

  /** Deletes every answer on this device. Forms stay. */
  deleteAnswers(): void {
    this.#change(() => ({ answers: [], release: nothingReleased, paper: [], asking: null }))
  }
}
