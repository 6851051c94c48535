import { expect, test } from 'vitest'
import { language, preferred } from './language.svelte.ts'

test('the first language of the browser that we speak is the language', () => {
  expect(preferred(['de-AT', 'en'])).toBe('de')
  expect(preferred(['xx', 'DE', 'en-GB'])).toBe('de')
  expect(preferred(['en-US', 'de'])).toBe('en')
})

test('English is spoken where none of them is there', () => {
  expect(preferred(['xx-YY', 'xz'])).toBe('en')
  expect(preferred([])).toBe('en')
})

test('a language is spoken once all that it needs has come, and the last request counts', async () => {
  const asked: string[] = []
  let come = () => {}
  language.needs((locale) => {
    asked.push(locale)
    return locale === 'de' ? new Promise<void>((done) => (come = done)) : Promise.resolve()
  })
  const german = language.speak('de')
  expect([language.locale, asked]).toEqual(['en', ['de']])
  await language.speak('en')
  come()
  await german
  expect(language.locale).toBe('en')
  const again = language.speak('de')
  come()
  await again
  expect(language.locale).toBe('de')
})
