import { expect, test } from 'vitest'
import { codeInLink, codeOf, fitsAsNickname, isComplete, wordsIn } from './code.ts'

test('a code is known by four words of at least four letters, in any letters', () => {
  expect(codeOf(['Kite', ' otte ', 'PLUM', 'rope'])).toBe('kite otte plum rope')
  expect(codeOf(['kite', 'ott', 'plum', 'rope'])).toBeNull()
  expect(codeOf(['kite', 'otter'])).toBeNull()
  expect(codeOf(['kite', 'otter', '', 'rope'])).toBeNull()
})

test('an older class has three words: its code is a code, and more may be typed', () => {
  expect(codeOf(['kite', 'otter', 'plum', ''])).toBe('kite otter plum')
  expect(isComplete(['kite', 'otter', 'plum', ''])).toBe(false)
  expect(isComplete(['kite', 'otter', 'plum', 'ro'])).toBe(false)
  expect(isComplete(['kite', 'otter', 'plum', 'rope'])).toBe(true)
})

test.each([
  'kite otter plum rope',
  'Kite-Otter-Plum-Rope',
  'kite, otter. plum; rope',
  '  kite  otter  plum  rope  again ',
])('four words are found in "%s"', (text) => expect(codeOf(wordsIn(text))).toBe('kite otter plum rope'))

test('a link carries the code behind its #, and other links none', () => {
  expect(codeInLink('#kite-otter-plum-rope')).toEqual(['kite', 'otter', 'plum', 'rope'])
  expect(codeInLink('#kite%20otter%20plum%20rope')).toEqual(['kite', 'otter', 'plum', 'rope'])
  expect(codeInLink('#kite-otter-plum')).toEqual(['kite', 'otter', 'plum'])
  for (const hash of ['', '#', '#main', '#a-b', '#%E0%A4%A']) expect(codeInLink(hash)).toBeNull()
})

test('a nickname has 2 to 20 letters, however they are made', () => {
  expect(['Fuchs', 'Zoë', '🦊🦊', 'x'.repeat(20)].map(fitsAsNickname)).toEqual([true, true, true, true])
  expect(['', ' a ', 'x'.repeat(21)].map(fitsAsNickname)).toEqual([false, false, false])
})
