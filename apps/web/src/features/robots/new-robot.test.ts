import 'fake-indexeddb/auto'
import { content } from '@botgarten/content/files'
import { most } from '@botgarten/programs'
import { afterEach, beforeEach, describe, expect, test } from 'vitest'
import type { LoadedCard } from '#content/cards.ts'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { fear, friendship } from '#storage/testing/sample.ts'
import { Robots } from './robots.svelte.ts'

beforeEach(freshDevice)
afterEach(closeSessions)

function robotsOf(project = friendship, card = 'friendship') {
  const { session } = sessionOf(project, { card: { card: content.card(card)!.card } as LoadedCard })
  return { session, robots: new Robots(session) }
}

describe('a new robot', () => {
  test('is chosen, and drives with weights of its own or a program of its own', () => {
    const { session, robots } = robotsOf()
    robots.asking = true
    robots.add('shared')
    expect([robots.ids, robots.chosen, robots.asking]).toEqual([['bo', 'bo2'], 'bo2', false])
    expect(session.lab.document.world.robots[1]).toMatchObject({ program: 'main', brain: 'bo2' })
    robots.add('own')
    expect(session.lab.document.world.robots[2]).toMatchObject({ program: 'bo3', brain: '' })
    session.undo.undo()
    expect(robots.ids).toEqual(['bo', 'bo2'])
  })

  test('is none where the world is full', () => {
    const { robots } = robotsOf()
    while (!robots.full) robots.add('shared')
    expect(robots.ids).toHaveLength(most.robots)
    robots.add('shared')
    expect(robots.ids).toHaveLength(most.robots)
  })
})

describe('a robot with the weights of another card', () => {
  test('is offered on a card that has one, as long as the first robot is alone', async () => {
    expect(robotsOf(friendship, 'four-brains').robots.beside).toBeUndefined()
    const { session, robots } = robotsOf(fear, 'fear')
    expect(robots.beside).toBe(session.opened.card!.card.beside)
    await robots.addBeside('Friendship')
    expect([robots.ids.length, robots.chosen === robots.ids[1], robots.beside]).toEqual([2, true, undefined])
    expect(robots.setOf(robots.chosen)).toBe('Friendship')
    await robots.addBeside('Friendship')
    expect(robots.ids).toHaveLength(2)
  })

  test('does not come where another robot came while its weights were looked up', async () => {
    const { robots } = robotsOf(fear, 'fear')
    const coming = robots.addBeside('Friendship')
    robots.add('shared')
    await coming
    expect(robots.ids).toEqual(['bo', 'bo2'])
  })
})

test('a set of weights has a name where it is not called like its robot', () => {
  const { robots } = robotsOf()
  robots.add('shared')
  expect([robots.setOf('bo'), robots.setOf('bo2'), robots.setOf('nobody')]).toEqual(['', '', ''])
})

test('the first robot stays, each other one can be removed', () => {
  const { robots } = robotsOf()
  robots.add('shared')
  robots.choose('bo')
  robots.remove()
  expect(robots.ids).toEqual(['bo', 'bo2'])
  robots.choose('bo2')
  robots.remove()
  expect([robots.ids, robots.chosen]).toEqual([['bo'], 'bo'])
})
