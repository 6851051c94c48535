import fc from 'fast-check'
import { expect, test } from 'vitest'
import { language } from '#words/language.svelte.ts'
import { nameOfCopy } from './messages.ts'

test('copies are counted, also the copies of a copy', async () => {
  for (const [locale, word] of [
    ['en', 'copy'],
    ['de', 'Kopie'],
  ] as const) {
    await language.speak(locale)
    expect(nameOfCopy('Fear', [])).toBe(`Fear (${word})`)
    expect(nameOfCopy(`Fear (${word})`, ['Fear'])).toBe(`Fear (${word} 2)`)
    expect(nameOfCopy(`Fear (${word} 9)`, [`Fear (${word})`, `Fear (${word} 2)`])).toBe(`Fear (${word} 3)`)
  }
})

test('a copy has a name that nothing else has, whatever a child has written', () => {
  fc.assert(
    fc.property(fc.string(), fc.array(fc.string()), (name, taken) => {
      expect([name, ...taken]).not.toContain(nameOfCopy(name, taken))
    }),
  )
})
