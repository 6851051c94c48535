import { content } from '@botgarten/content/files'
import type { FormItem } from '@botgarten/content/questionnaires'

/** Of the answer of the n-th child: as many digits as chance would give. */
export const idOf = (child: number): string => child.toString(16).padStart(32, '0')

function valueOf(item: FormItem, child: number): string {
  if (item.kind === 'scale') return String((child % 5) + 1)
  if (item.kind === 'choice') return item.choices[child % item.choices.length]!
  if (item.kind === 'text') return `Satz ${child}`
  return content.questions.find(({ id }) => id === item.question)!.answer
}

/** What the n-th child sends for a form of the product. */
export function answerOf(form: string, child: number) {
  const { items } = content.forms.find((one) => one.form.id === form)!.form
  const values = Object.fromEntries(items.map((item) => [item.id, valueOf(item, child)]))
  return { id: idOf(form.length * 1000 + child), code: `owl-${100 + child}`, values }
}
