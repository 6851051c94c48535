import { expect, test, vi } from 'vitest'
import { m } from '#words/message.ts'
import { language } from './language.svelte.ts'
import { hasMessage, message, wordsIn } from './message.ts'

test('a message says its facts; a key that nobody wrote comes back', () => {
  const facts = { label: 'Abstand', place: 'links' }
  expect(wordsIn('de')('network.name', facts)).toBe('Abstand links')
  const told = vi.spyOn(console, 'error').mockImplementation(() => {})
  expect(message('nobody.wrote.this')).toBe('nobody.wrote.this')
  expect(told).toHaveBeenCalledOnce()
  expect([hasMessage('world.lost'), hasMessage('projects.renamed'), hasMessage('nobody.wrote.this')]).toEqual(
    [true, true, false],
  )
})

test('a message of the built product says its words in the language of now', async () => {
  await language.speak('de')
  expect(m['world.lost']()).toBe('Bo steckt fest.')
  await language.speak('en')
  expect(m['world.lost']()).toBe('Bo is stuck.')
})

test.each([
  ['sorting.readingCount', { count: 1 }, '1 Messwert', '1 reading'],
  ['q.byEpisodes', { count: 1 }, 'Der eine Versuch ist vorbei.', 'The one try is done.'],
  ['q.byEpisodes', { count: 1000 }, 'Alle 1.000 Versuche sind vorbei.', 'All 1,000 tries are done.'],
  ['projects.days', { days: 1 }, 'Letzter Tag', 'Last day'],
  ['home.level', { passed: 0, of: 1 }, '0 von 1 Platz geschafft', '0 of 1 place done'],
])('"%s" of %o has its singular where there is one', (key, facts, german, english) => {
  expect([wordsIn('de')(key, facts), wordsIn('en')(key, facts)]).toEqual([german, english])
})
