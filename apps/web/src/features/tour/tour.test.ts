import { networks, type NetworkOutline, type Program } from '@botgarten/programs'
import { cardConfig } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import friendship from '../../../../../content/cards/network/05-friendship/start.json'
import chameleon from '../../../../../content/cards/network/01-chameleon/start.json'
import { sightOf } from './tour.ts'

const netOf = (card: { programs: { main: unknown } }): NetworkOutline =>
  networks(card.programs.main as Program)[0]!

test('the tour shows the first neuron that drives a wheel', () => {
  expect(sightOf(netOf(friendship), cardConfig)).toMatchObject({
    neuron: { id: 'wheelLeft' },
    wheel: 'motor C',
    side: 'left',
  })
})

test('a network that drives no wheel, and a program without one, have no tour', () => {
  expect(sightOf(netOf(chameleon), cardConfig)).toBeNull()
  expect(sightOf(null, cardConfig)).toBeNull()
  const turned = { ...cardConfig, drive: { left: 'A', right: 'D' } } as const
  expect(sightOf(netOf(friendship), turned)).toBeNull()
})
