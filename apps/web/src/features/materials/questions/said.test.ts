import { readQuestionText } from '@botgarten/content/questions'
import { expect, test } from 'vitest'
import { language } from '#words/language.svelte.ts'
import { saidAnswer, saidQuestion } from './said.ts'

const text = readQuestionText(
  '# What does Bo do?\n\n## Choices\n\n- drives: It drives\n- stands: It stands still.\n\n## Why\n\nAll knobs are at **0**\n',
)

test('a question is asked before its choices, in their order, each a sentence', () => {
  expect(saidQuestion(text, ['stands', 'drives'])).toBe('What does Bo do? It stands still. It drives.')
})

test.each([
  ['en', true, 'You said it before. That is what happens: It stands still. All knobs are at 0.'],
  ['en', false, 'It goes another way. That is what happens: It stands still. All knobs are at 0.'],
  ['de', true, 'Du hast es vorher gewusst. Das passiert: It stands still. All knobs are at 0.'],
] as const)('in %s an answer says what happens before why', async (locale, guessed, said) => {
  await language.speak(locale)
  expect(saidAnswer(text, 'stands', guessed)).toBe(said)
})
