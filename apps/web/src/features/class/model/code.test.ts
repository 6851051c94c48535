import { expect, test } from 'vitest'
import { codeInLink, codeOf, fitsAsNickname, wordsIn } from './code.ts'

test('a code is known by three words of at least four letters, in any letters', () => {
  expect(codeOf(['Kite', ' otte ', 'PLUM'])).toBe('kite otte plum')
  expect(codeOf(['kite', 'ott', 'plum'])).toBeNull()
  expect(codeOf(['kite', 'otter'])).toBeNull()
})

test.each(['kite otter plum', 'Kite-Otter-Plum', 'kite, otter. plum', '  kite  otter  plum  again '])(
  'three words are found in "%s"',
  (text) => expect(codeOf(wordsIn(text))).toBe('kite otter plum'),
)

test('a link carries the code behind its #, and other links none', () => {
  expect(codeInLink('#kite-otter-plum')).toEqual(['kite', 'otter', 'plum'])
  expect(codeInLink('#kite%20otter%20plum')).toEqual(['kite', 'otter', 'plum'])
  for (const hash of ['', '#', '#main', '#a-b', '#%E0%A4%A']) expect(codeInLink(hash)).toBeNull()
})

test('a nickname has 2 to 20 letters, however they are made', () => {
  expect(['Fuchs', 'Zoë', '🦊🦊', 'x'.repeat(20)].map(fitsAsNickname)).toEqual([true, true, true, true])
  expect(['', ' a ', 'x'.repeat(21)].map(fitsAsNickname)).toEqual([false, false, false])
})
