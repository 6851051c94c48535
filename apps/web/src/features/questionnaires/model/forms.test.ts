import content from 'content:questionnaires'
import { expect, test } from 'vitest'
import { questionOf } from './forms.ts'

const after = content.forms.find(({ form }) => form.id === 'after')!
const text = after.text['en']!
const itemOf = (id: string) => after.form.items.find((item) => item.id === id)!

test('a question is asked in the words for its place, and in its full words where it has no others', () => {
  const { question, here, young } = text.words['interest-supervised']!
  expect(new Set([question, here, young]).size).toBe(3)
  const item = itemOf('interest-supervised')
  expect(questionOf(item, text, 'question')).toBe(question)
  expect(questionOf(item, text, 'here')).toBe(here)
  expect(questionOf(item, text, 'young')).toBe(young)
  expect(text.words['take-along']!['here']).toBeUndefined()
  expect(questionOf(itemOf('take-along'), text, 'here')).toBe(text.words['take-along']!['question'])
})
