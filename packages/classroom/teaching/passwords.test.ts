import fc from 'fast-check'
import { expect, test } from 'vitest'
import { weaknessOf } from './passwords.ts'

const names = ['m.weber', 'Die Igel', '5b']

test.each([
  'basketball',
  'Password123',
  'passwort2026!',
  '123Schalke04',
  'passwortpasswort',
  'aaaaaaaaaaaa',
  '1212121212',
  '1234567890',
  '9876543210',
  'abcdefghij',
  'Qwertzuiop12',
  'asdfghjklö',
  '5b5b5b5b5b',
  'ＰＡＳＳＷＯＲＴ１２３',
])('%s is refused as common', async (password) => {
  expect(await weaknessOf(password, names)).toBe('passwordCommon')
})

test.each(['botgarten1', 'Botgarten-2026', 'M.Weber12345', 'botgarten.m.weber', 'die igel 2026'])(
  '%s is refused as made of names that go with the account',
  async (password) => {
    expect(await weaknessOf(password, names)).toBe('passwordOfNames')
  },
)

test.each([
  'kastanie im regen',
  'botgarten-im-regen',
  'm.weber mag kastanien',
  'sonnenblume-schnee',
  'XtK7-q2mP-vvL9',
  '8203641957',
  '7392016abc',
  '12 ab 34 cd',
])('%s may be chosen', async (password) => {
  expect(await weaknessOf(password, names)).toBeNull()
})

test('property: three words of a child’s story may always be chosen', async () => {
  const word = fc.constantFrom('kastanie', 'regen', 'tulpe', 'schnee', 'mond', 'igelkind', 'robot', 'brook')
  await fc.assert(
    fc.asyncProperty(fc.uniqueArray(word, { minLength: 3, maxLength: 3 }), async (words) => {
      expect(await weaknessOf(words.join(' '), names)).toBeNull()
    }),
  )
})
