import content from 'content:questionnaires'
import { expect, test } from 'vitest'
import { Typing } from './typing.svelte.ts'

const after = content.forms.find(({ form }) => form.id === 'after')!

test('counts from paper are counts once there are five sheets, and none of an item more than sheets', () => {
  const typing = new Typing(after)
  typing.sheets = 4
  expect([typing.isEnough, typing.made]).toEqual([false, null])
  typing.sheets = 6
  typing.grade = 8
  typing.counts['go-on'] = [5, 2, 0]
  expect([typing.tooMany, typing.made]).toEqual([['go-on'], null])
  typing.counts['go-on'] = [5, 1, 0]
  typing.lines['take-along'] = 'Zwei\n\n  Eins \n'
  expect(typing.made).toMatchObject({ form: 'after', bands: ['7-9'], n: 6 })
  expect(typing.made!.counts['go-on']).toEqual([5, 1, 0])
  expect(typing.made!.open['take-along']).toEqual(['Eins', 'Zwei'])
})

test('a field that was emptied counts nothing', () => {
  const typing = new Typing(after)
  typing.sheets = 7
  typing.counts['go-on'] = [undefined as unknown as number, 3, Number.NaN]
  expect(typing.made!.counts['go-on']).toEqual([0, 3, 0])
})

test('what was not typed in counts 0 for every answer', () => {
  const typing = new Typing(after)
  typing.sheets = 5
  expect(typing.made!.counts['go-on']).toEqual([0, 0, 0])
  expect(typing.made!.counts['interest-supervised']).toEqual([0, 0, 0, 0, 0])
})
