import { expect, test } from 'vitest'
import { preferred } from './language.svelte.ts'

test('the first wish of the browser that we speak is the language', () => {
  expect(preferred(['de-AT', 'en'])).toBe('de')
  expect(preferred(['fr', 'DE', 'en-GB'])).toBe('de')
  expect(preferred(['en-US', 'de'])).toBe('en')
})

test('English is spoken where no wish can be met', () => {
  expect(preferred(['fr-CH', 'it'])).toBe('en')
  expect(preferred([])).toBe('en')
})
