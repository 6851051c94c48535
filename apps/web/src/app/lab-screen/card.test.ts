import { loadCard } from '#content/cards.ts'
import { expect, test } from 'vitest'
import { taskOf } from './card.ts'

test('on another map than its own the sentence of a card follows the map, and no goal is shown', async () => {
  const card = await loadCard('mars')
  expect(taskOf(card, [], []).goals).toHaveLength(2)
  const { title, sentence, goals } = taskOf(card, [], [], { map: 'Lake', start: 0, goal: 15 })
  expect(title).toMatch(/0.*15/)
  expect(sentence).toContain('Lake')
  expect(goals).toEqual([])
})
