import content from 'content:questionnaires'
import { expect, test } from 'vitest'
import { Filling, isYoung } from './filling.svelte.ts'

const after = content.forms.find(({ form }) => form.id === 'after')!

test('from grade 5 on the form has six screens, before one for every question', () => {
  expect([isYoung(4), isYoung(5)]).toEqual([true, false])
  expect(new Filling(after, false).screens).toHaveLength(6)
  expect(new Filling(after, true).screens).toHaveLength(after.form.items.length)
})

test('what is left out is not there, and an answer can be changed', () => {
  const filling = new Filling(after, false)
  filling.answer('interest-supervised', '4')
  filling.answer('ease-supervised', '2')
  filling.answer('interest-supervised', '5')
  expect(filling.values).toEqual({ 'interest-supervised': '5', 'ease-supervised': '2' })
  filling.skip()
  expect(filling.values).toEqual({})
  filling.answer('take-along', '  ')
  expect(filling.values).toEqual({})
})
