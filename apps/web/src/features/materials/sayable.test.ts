import { readItemText } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { language } from '#words/language.svelte.ts'
import { flows } from './drawn/flow/flows.ts'
import { wordOf } from './drawn/flow/flow.ts'
import { sayable, answerAloud, questionAloud, slideAloud } from './sayable.ts'
import { readQuestionText } from '@botgarten/content/questions'
import { fetchItems } from './library.ts'
import { slidesOf } from './slides/deck.ts'

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

const text = readQuestionText(
  '# What does Bo do?\n\n## Choices\n\n- drives: It drives\n- stands: It stands still.\n\n## Why\n\nAll knobs are at **0**\n',
)

test('a question is asked before its choices, in their order, each a sentence', () => {
  expect(questionAloud(text, ['stands', 'drives'])).toBe('What does Bo do? It stands still. It drives.')
})

test.each([
  ['en', true, 'You said it before. That is what happens: It stands still. All knobs are at 0.'],
  ['en', false, 'It goes another way. That is what happens: It stands still. All knobs are at 0.'],
  ['de', true, 'Du hast es vorher gewusst. Das passiert: It stands still. All knobs are at 0.'],
] as const)('in %s an answer says what happens before why', async (locale, guessed, said) => {
  await language.speak(locale)
  expect(answerAloud(text, 'stands', guessed)).toBe(said)
})

const deckOf = (markdown: string) => slidesOf(readItemText(`# Deck\n\nBelow.\n\n${markdown}\n`))

test('what stands on a slide is said in its order, sentence by sentence', () => {
  const [first, second] = deckOf('## What is it?\n\n- one\n- two\n\n![Three flags](flags.svg)') as [
    never,
    never,
  ]
  expect(slideAloud(first)).toBe('Deck. Below.')
  expect(slideAloud(second)).toBe('What is it? one. two. Three flags.')
})

test('what the teacher says to a slide is never read', () => {
  const [, slide] = deckOf('## One\n\nSeen.\n\n### Notes\n\nNot for all ears.') as [never, never]
  expect(slideAloud(slide)).toBe('One. Seen.')
})

test('a list of questions is read; on the whole screen each of them has a voice of its own', async () => {
  await language.speak('en')
  await fetchItems('en')
  const [, slide] = deckOf('## Guess\n\n::questions{module=1}') as [never, never]
  expect(slideAloud(slide)).toMatch(/^Guess\. [^?]+\? ([^.?]+\. ){2,}/)
  expect(slideAloud(slide, true)).toBe('Guess.')
})
