import { steps, type Form } from '@botgarten/content/questionnaires'
import type { Question } from '@botgarten/content/questions'
import type { Answer, Column } from './types.ts'

/**
 * The items of a form as they are counted.
 * @param questions the questions about what Bo does, whose choices and answers are taken
 * @throws RangeError where the form asks a question that there is not
 */
export const columnsOf = ({ items }: Form, questions: readonly Question[]): readonly Column[] =>
  items.map((item): Column => {
    const { id, kind } = item
    if (kind === 'scale') return { id, kind, options: steps }
    if (kind === 'choice') return { id, kind, options: item.choices }
    if (kind === 'text') return { id, kind, options: [] }
    const question = questions.find((one) => one.id === item.question)
    if (!question) throw new RangeError(`There is no question "${item.question}".`)
    return { id, kind, options: question.choices, answer: question.answer }
  })

/** What was answered to an item; undefined where nothing was, or something that its form does not know. */
export function valueOf({ id, kind, options }: Column, { values }: Answer): string | undefined {
  const value = Object.hasOwn(values, id) ? values[id] : undefined
  if (value === undefined || (kind !== 'text' && !options.includes(value))) return undefined
  return value
}

/** How many of the questions about the robot were answered right. */
export const scoreOf = (columns: readonly Column[], answer: Answer): number =>
  columns.filter((column) => column.kind === 'robot' && valueOf(column, answer) === column.answer).length
