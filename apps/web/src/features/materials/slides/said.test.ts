import { readItemText } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { fetchItems } from '../library.ts'
import { slidesOf } from './deck.ts'
import { saidOf } from './said.ts'

const deckOf = (markdown: string) => slidesOf(readItemText(`# Deck\n\nBelow.\n\n${markdown}\n`))

test('what stands on a slide is said in its order, sentence by sentence', () => {
  const [first, second] = deckOf('## What is it?\n\n- one\n- two\n\n![Three flags](flags.svg)') as [
    never,
    never,
  ]
  expect(saidOf(first)).toBe('Deck. Below.')
  expect(saidOf(second)).toBe('What is it? one. two. Three flags.')
})

test('what the teacher says to a slide is never read', () => {
  const [, slide] = deckOf('## One\n\nSeen.\n\n### Notes\n\nNot for all ears.') as [never, never]
  expect(saidOf(slide)).toBe('One. Seen.')
})

test('a list of questions is read; on the whole screen each of them has a voice of its own', async () => {
  await fetchItems('en')
  const [, slide] = deckOf('## Guess\n\n::questions{module=1}') as [never, never]
  expect(saidOf(slide)).toMatch(/^Guess\. [^?]+\? ([^.?]+\. ){2,}/)
  expect(saidOf(slide, true)).toBe('Guess.')
})
