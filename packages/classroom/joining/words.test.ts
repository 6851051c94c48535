import fc from 'fast-check'
import { codeWords } from '@botgarten/content/codes'
import { expect, test } from 'vitest'
import { codeKey, isShortCode, newCode, wordsOfKey } from './code.ts'
import { nicknameFrom, nicknameKey } from './nickname.ts'
import { newSecret, pictures } from './pictures.ts'

const random = (bytes: number) => crypto.getRandomValues(new Uint8Array(bytes))

test.each([
  'kite otter plum rope',
  'KITE OTTER PLUM ROPE',
  ' kite-otter-plum-rope ',
  'kite·otte·plum·rope',
  'kite, otterly, plums; ropes',
])('the code %s is kite, otter, plum, rope', (text) => expect(codeKey(text)).toBe('kite-otte-plum-rope'))

test('a code of three words, as classes had before, is one as well', () => {
  expect(codeKey('Kite Otter Plum')).toBe('kite-otte-plum')
  expect(['kite-otte-plum', 'kite-otte-plum-rope', ''].map(isShortCode)).toEqual([true, false, false])
})

test.each(['', 'kite', 'kite otter', 'kite otter plum rope moon', '123'])('%j is no code', (text) =>
  expect(codeKey(text)).toBeNull(),
)

test('a new code is four words of the list, is found by its first letters, and is shown as complete words', () => {
  for (const language of ['de', 'en'] as const) {
    const words = newCode(language, random).split(' ')
    expect(words).toHaveLength(4)
    for (const word of words) expect(codeWords(language)).toContain(word)
    expect(codeKey(words.join(' '))).toBe(words.map((word) => word.slice(0, 4)).join('-'))
    expect(wordsOfKey(codeKey(words.join(' '))!, language)).toEqual(words)
  }
})

test('a new code never has the same word twice', () => {
  const drawn = [7, 7, 7, 8, 7, 8, 9, 6]
  const list = codeWords('en')
  expect(newCode('en', () => Uint8Array.of(0, drawn.shift()!))).toBe(
    [7, 8, 9, 6].map((at) => list[at]).join(' '),
  )
})

test('25 million guesses a day find the code of a class with less than 0.01 %, at four nodes as well', () => {
  const words = codeWords('de').length
  const codes = words * (words - 1) * (words - 2) * (words - 3)
  expect(codes).toBeGreaterThanOrEqual(2.5e11)
  expect((4 * 25_000_000) / codes).toBeLessThan(0.0001)
})

test.each(['Fuchs', 'Mia 7', 'Łukasz', 'Özlem', '小明', 'Nguyễn', 'अमित', '42'])('%s is a nickname', (name) =>
  expect(nicknameFrom(name)).toBe(name.normalize('NFKC')),
)

test.each(['a', '', '  ', 'x'.repeat(21), 'Fuchs🦊', 'a_b', '<b>hi</b>', 'a\tb', '=1+1', 'z̶̡̛a̶l'])(
  '%j is no nickname',
  (name) => expect(nicknameFrom(name)).toBeNull(),
)

test('nicknames that look alike in other letters, widths or capitals have one key', () => {
  const same = [
    ['Fuchs', 'FUCHS'],
    ['Ｆｕｃｈｓ', 'fuchs'],
    ['Strauß', 'STRAUSS'],
    ['ﬁsch', 'fisch'],
  ]
  for (const [one, other] of same) expect(nicknameKey(one!)).toBe(nicknameKey(other!))
})

test('any text gives a nickname of 2 to 20 letters or none, and a nickname stays what it is', () =>
  fc.assert(
    fc.property(fc.string({ unit: 'binary', maxLength: 30 }), (text) => {
      const name = nicknameFrom(text)
      if (name === null) return
      expect([...name].length).toBeGreaterThanOrEqual(2)
      expect([...name].length).toBeLessThanOrEqual(20)
      expect(nicknameFrom(name)).toBe(name)
    }),
  ))

test('three different pictures in an order: all twelve turn up at each place', () => {
  const secrets = Array.from({ length: 600 }, () => newSecret(random))
  expect(secrets.every((three) => new Set(three).size === 3)).toBe(true)
  for (const place of [0, 1, 2])
    expect(new Set(secrets.map((three) => three[place])).size).toBe(pictures.length)
})
