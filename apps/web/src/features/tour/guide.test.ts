import { content } from '@botgarten/content/files'
import { networks, type NetworkOutline } from '@botgarten/programs'
import { cardConfig } from '@botgarten/simulation'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { readSetting } from '#storage/settings.ts'
import { Guide, sightOf } from './guide.svelte.ts'

beforeEach(() => void freshLocalStorage())
afterEach(() => void vi.unstubAllGlobals())

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

test('a network that drives the right wheel alone has its tour there', () => {
  const right = { ...cardConfig, drive: { left: 'A', right: 'C' } } as const
  expect(sightOf(netOf('friendship'), right)).toMatchObject({ neuron: { id: 'wheelLeft' }, side: 'right' })
})

test('a move that was reached stays reached; the next one is not', () => {
  const guide = new Guide()
  guide.go(0)
  expect(guide.isReached).toBe(false)
  guide.reach()
  expect(guide.isReached).toBe(true)
  guide.go(1)
  expect(guide.isReached).toBe(false)
})

test('the tour is offered once on a device: closed it does not come again', () => {
  const guide = new Guide()
  expect(guide.move).toBe(-1)
  guide.go(2)
  expect([guide.move, readSetting('tour', null)]).toEqual([2, null])
  guide.close()
  expect([guide.move, readSetting('tour', null), new Guide().move]).toEqual([null, 'seen', null])
})

test('a part that is touched before the tour has begun reaches no move', () => {
  const guide = new Guide()
  guide.close()
  guide.reach()
  guide.go(0)
  expect(guide.isReached).toBe(false)
  guide.go(1)
  expect(guide.isReached).toBe(false)
})
