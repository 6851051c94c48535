import { content } from '@botgarten/content/files'
import { expect, test } from 'vitest'
import { goalsOf } from './goals.ts'

test('the flag of Straight on is a place that matters, a place after others is none', () => {
  expect(goalsOf(content.card('forward')!.card.checks)).toEqual([{ x: 210, y: 100, radius: 24 }])
  expect(goalsOf(content.card('square')!.card.checks)).toEqual([])
})
