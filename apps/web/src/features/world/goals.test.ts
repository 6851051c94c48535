import { content } from '@botgarten/content/files'
import { expect, test } from 'vitest'
import { asksForColours, goalsOf } from './goals.ts'

test('the flag of Straight on is a place that matters, a place after others is none', () => {
  expect(goalsOf(content.card('forward')!.card.checks)).toEqual([{ x: 210, y: 100, radius: 24 }])
  expect(goalsOf(content.card('square')!.card.checks)).toEqual([])
})

test('cards about colours show as much of the floor as they can, unless the colour is the one to avoid', () => {
  const ids = content.cards.map(({ id }) => id)
  const asking = ids.filter((id) => asksForColours(content.card(id)!.card.checks))
  expect(asking).toEqual(['chameleon', 'caution', 'interest', 'either-or', 'say-it', 'either-or-2'])
})
