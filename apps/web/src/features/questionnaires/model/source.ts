import type { Growth, Tally } from '@botgarten/answers'
import type { LoadedForm } from '@botgarten/content/questionnaires'

/** A table: its head, and a row each. */
export type Rows = readonly (readonly (string | number)[])[]

/** What children guessed right in two forms, joined by their codes. */
export interface JoinedGrowth {
  readonly before: LoadedForm
  readonly after: LoadedForm
  readonly growth: Growth
}

/** Where results come from: this device, or a class. */
export interface Source {
  readonly forms: readonly LoadedForm[]
  /** Is the form being asked now? Then it has no results. */
  isOpen(form: string): boolean
  /** How many have answered; null: some, and fewer than five. */
  count(form: string): number | null
  /** What is published of a form. */
  tallies(loaded: LoadedForm): readonly Tally[]
  /** Those whose answers are published, a row each. */
  rows(loaded: LoadedForm): Promise<Rows>
  growths(forms: readonly LoadedForm[]): readonly JoinedGrowth[]
  /** Ends the questions. */
  close(form: string): void
}
