import { expect, test } from 'vitest'
import { addressFor, isOwnMachine } from './address.ts'

const own = { hostname: 'localhost', origin: 'http://localhost:4173' }
const inRoom = { hostname: 'botgarten.local', origin: 'http://botgarten.local' }
const addresses = ['http://localhost:4173', 'http://192.168.0.5:4173']

test.each(['localhost', '127.0.0.1', '[::1]'])('%s is a name for the machine itself', (name) =>
  expect(isOwnMachine(name)).toBe(true),
)

test('pupils get the address of the page, or one of the network where the page is on the server itself', () => {
  expect(addressFor(inRoom, addresses)).toBe('http://botgarten.local')
  expect(addressFor(own, addresses)).toBe('http://192.168.0.5:4173')
  expect(addressFor(own, ['http://localhost:4173'])).toBe('http://localhost:4173')
})
