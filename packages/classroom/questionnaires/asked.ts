import { readAnswer, valueOf, type Answer, type Column } from '@botgarten/answers'
import { moments, type LoadedForm } from '@botgarten/content/questionnaires'
import type { AnswerRow, AskingRow } from '../database/answers/tables.ts'

/** A form as a class is asked it, with what is counted of it. */
export interface Asked extends LoadedForm {
  readonly columns: readonly Column[]
}

export const askedIn = ({ document }: Pick<AskingRow, 'document'>): Asked => JSON.parse(document) as Asked

/** Forms in the order in which they are filled in. */
export const inTime = (askings: readonly AskingRow[]): readonly AskingRow[] => {
  const at = (asking: AskingRow) => moments.indexOf(askedIn(asking).form.moment)
  return askings.toSorted((a, b) => at(a) - at(b) || a.form.localeCompare(b.form))
}

/** The grades that an answer can have. */
export const gradeIn = (grade: number): number => Math.min(12, Math.max(3, grade))

/** What a child has sent, as an answer to its form: what the form does not know is left out. @throws ValiError for what is none */
export function readSent(
  asking: AskingRow,
  sent: {
    readonly id: string
    readonly code: string | null
    readonly values: { readonly [item: string]: string }
  },
): Answer {
  const { form, grade, day } = asking
  const answer = readAnswer({ ...{ form, grade, day }, ...sent })
  const known = askedIn(asking).columns.flatMap((column) => {
    const value = valueOf(column, answer)
    return value === undefined ? [] : [[column.id, value] as const]
  })
  return { ...answer, values: Object.fromEntries(known) }
}

/** A row as the answer that it is. */
export const answerIn = ({ form, grade, day }: AskingRow, { id, code, chosen }: AnswerRow): Answer => ({
  ...{ id, form, grade, code, day },
  values: JSON.parse(chosen) as Answer['values'],
})
