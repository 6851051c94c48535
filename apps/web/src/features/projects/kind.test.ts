import { expect, test } from 'vitest'
import { allCards } from '#content/cards.ts'
import { icon } from '#parts/icons.ts'
import { kindOf, kinds } from './kind.ts'

const of = (card: string | undefined) => kindOf({ project: { card } } as Parameters<typeof kindOf>[0])

test.each([
  ['friendship', 'network'],
  ['railway', 'trying'],
  ['try-dodge', 'trying'],
  ['tidy-up', 'sorting'],
  [undefined, 'free'],
  ['a card of a later version', 'free'],
])('a project of %s is of the kind %s', (card, kind) => {
  expect(of(card)).toBe(kind)
})

test('a project of the sorting playground is of that kind', () => {
  expect(kindOf({ project: { playground: 'sorting' } } as Parameters<typeof kindOf>[0])).toBe('sorting')
})

test('every card has the kind of its bed, and only cards with a network are called so', () => {
  for (const { id, bed } of allCards)
    expect(of(id) === 'network', id).toBe(bed === 'network' && of(id) !== 'trying')
})

test('a project with a card of its own is of that kind, whatever card it was made from', () => {
  const project = { card: 'friendship', ownCard: {} }
  expect(kindOf({ project } as unknown as Parameters<typeof kindOf>[0])).toBe('card')
})

test('every kind has an icon that is drawn', () => {
  for (const [kind, look] of Object.entries(kinds)) expect(icon(look.icon), kind).toBeDefined()
})
