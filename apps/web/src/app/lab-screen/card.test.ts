import { titleOf } from '#content/names.ts'
import { loadCard } from '#content/cards.ts'
import { expect, test } from 'vitest'
import { nextStep, taskOf } from './card.ts'

test('on another map than its own the sentence of a card follows the map, and no goal is shown', async () => {
  const card = await loadCard('mars')
  expect(taskOf(card, [], []).goals).toHaveLength(2)
  const { title, sentence, goals } = taskOf(card, [], [], { map: 'Lake', start: 0, goal: 15 })
  expect(title).toMatch(/0.*15/)
  expect(sentence).toContain('Lake')
  expect(goals).toEqual([])
})

test('after the last start place a card leads to the next card, or to the zoo or home where its bed ends', async () => {
  const stepAfter = async (id: string) => {
    const card = (await loadCard(id))!
    return nextStep(
      card,
      card.card.starts.map((_, start) => start),
    )
  }
  expect(await stepAfter('either-or')).toEqual({
    kind: 'card',
    href: '/lab/show-it',
    name: titleOf('show-it'),
  })
  expect(await stepAfter('cheating')).toEqual({ kind: 'zoo', href: '/zoo' })
  expect(await stepAfter('new-colours')).toEqual({ kind: 'home', href: '/' })
})
