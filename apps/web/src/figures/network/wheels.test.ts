import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { afterEach, expect, test } from 'vitest'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { setsBothWheels } from './wheels.ts'

afterEach(closeSessions)

/** Of the solution of a card. */
function asksForWheel(id: string): boolean {
  const { card, world } = content.card(id)!
  const { session } = sessionOf(cardProject(world, card, content.program(id, 'solution')!, id))
  return setsBothWheels(session.outlines, session.config)
}

test.each(['friendship', 'fear', 'rally'])('%s: the network sets both wheels', (id) => {
  expect(asksForWheel(id)).toBe(true)
})

test.each(['loud-distance', 'if-then', 'chameleon'])(
  '%s: no network sets wheels, so a bump is not its fault',
  (id) => {
    expect(asksForWheel(id)).toBe(false)
  },
)
