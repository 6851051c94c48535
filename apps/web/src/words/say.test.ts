import { expect, test, vi } from 'vitest'
import * as m from '#words/generated/messages.js'
import { language } from './language.svelte.ts'
import { isSaid, say, wordsIn } from './say.ts'

test('a message says its facts; a key that nobody wrote comes back', () => {
  const facts = { label: 'Abstand', place: 'links' }
  expect(wordsIn('de')('network.name', facts)).toBe('Abstand links')
  const told = vi.spyOn(console, 'error').mockImplementation(() => {})
  expect(say('nobody.wrote.this')).toBe('nobody.wrote.this')
  expect(told).toHaveBeenCalledOnce()
  expect([isSaid('world.lost'), isSaid('projects.renamed'), isSaid('nobody.wrote.this')]).toEqual([
    true,
    true,
    false,
  ])
})

test('a message of the built product says its words in the language of now', async () => {
  await language.speak('de')
  expect(m['world.lost']()).toBe('Bo steckt fest.')
  await language.speak('en')
  expect(m['world.lost']()).toBe('Bo is stuck.')
})
