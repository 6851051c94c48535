import { content } from '@botgarten/content/files'
import { networks, type NetworkOutline } from '@botgarten/programs'
import { cardConfig } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { sightOf } from './guide.svelte.ts'

const netOf = (card: string): NetworkOutline =>
  networks(content.program(card, 'start')!.programs['main']!)[0]!

test('the tour shows the first neuron that drives a wheel', () => {
  expect(sightOf(netOf('friendship'), cardConfig)).toMatchObject({
    neuron: { id: 'wheelLeft' },
    wheel: 'motor C',
    side: 'left',
  })
})

test('a network that drives no wheel, and a program without one, have no tour', () => {
  expect(sightOf(netOf('chameleon'), cardConfig)).toBeNull()
  expect(sightOf(null, cardConfig)).toBeNull()
  const turned = { ...cardConfig, drive: { left: 'A', right: 'D' } } as const
  expect(sightOf(netOf('friendship'), turned)).toBeNull()
})
