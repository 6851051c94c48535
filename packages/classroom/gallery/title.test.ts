import fc from 'fast-check'
import { expect, test } from 'vitest'
import { titleFrom } from './title.ts'

test.each([
  ['Rally, fast one', 'Rally, fast one'],
  ['  zwei   Wörter\n', 'zwei Wörter'],
  ['🐢 langsam', '🐢 langsam'],
  ['<img src=x onerror=alert(1)>', '<img src=x onerror=alert(1)>'],
  ['abc\u202edcba', 'abc dcba'],
  [`a${'\u0301'.repeat(50)}`, 'á\u0301\u0301'],
  ['x'.repeat(60), 'x'.repeat(60)],
])('%j is shown as %j', (text, title) => expect(titleFrom(text)).toBe(title))

test.each(['', '  ', '\u200b', '\u0301', '\u202e', '\n\t', 'x'.repeat(61)])('%j is no title', (text) =>
  expect(titleFrom(text)).toBeNull(),
)

test('any text becomes a short line without what turns it around, and stays so', () => {
  fc.assert(
    fc.property(fc.string({ unit: 'binary', maxLength: 80 }), (text) => {
      const title = titleFrom(text)
      if (title === null) return
      expect([...title].length).toBeLessThanOrEqual(60)
      expect(title).not.toMatch(/[\p{Cc}\u202a-\u202e\u2066-\u2069]/u)
      expect(titleFrom(title)).toBe(title)
    }),
  )
})
