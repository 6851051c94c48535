import { content } from '@botgarten/content/files'
import type { FormItem } from '@botgarten/content/questionnaires'

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
  return { code: `owl-${100 + child}`, values }
}
