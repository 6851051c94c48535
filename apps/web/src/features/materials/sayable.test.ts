import { readItemText } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { language } from '#words/language.svelte.ts'
import { flows } from './drawn/flow/flows.ts'
import { wordOf } from './drawn/flow/words.ts'
import { sayable } from './sayable.ts'

const leadOf = (markdown: string) => sayable(readItemText(`# Title\n\n${markdown}\n`).lead)

test('headings, paragraphs and lines are sentences of their own', () => {
  expect(leadOf('Look **closely**\n\n- one\n- two *things*')).toBe('Look closely. one. two things.')
})

test('a table is said row by row, without the cells that are written into', () => {
  expect(leadOf('| Who | When |\n| --- | --- |\n| Ada | |\n| Bo | now |')).toBe('Who, When. Ada. Bo, now.')
})

test('a picture is said by its words, and a link by its own', () => {
  expect(leadOf('![Three flags](flags.svg)\n\nOpen [the lab](card:fear)')).toBe('Three flags. Open the lab.')
})

test('where there is only a drawing nothing is said', () => {
  expect(leadOf('::world{id=garden}')).toBeNull()
})

test.each([
  ['de', 'Nach 5 Minuten tauschen.'],
  ['en', 'Swap after 5 minutes.'],
] as const)('in %s a clock says when to swap', async (locale, said) => {
  await language.speak(locale)
  expect(leadOf('::timer{minutes=5}')).toBe(said)
})

test('what stands in the boxes of a flow diagram is said box by box', () => {
  const said = leadOf('::flow{id=q-learning}')
  for (const { id } of flows['q-learning'].boxes) expect(said).toContain(wordOf(id))
})
