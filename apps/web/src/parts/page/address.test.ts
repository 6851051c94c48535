import { expect, test } from 'vitest'
import { addressFor, isOwnMachine } from './address.ts'

const page = { origin: 'http://botgarten.local' }

test.each(['localhost', '127.0.0.1', '[::1]'])('%s is a name for the machine itself', (name) =>
  expect(isOwnMachine(name)).toBe(true),
)

test('pupils get the address that the server announces, else that of the page', () => {
  expect(addressFor(page, 'http://192.168.0.5:4173')).toBe('http://192.168.0.5:4173')
  expect(addressFor(page, null)).toBe('http://botgarten.local')
})
