import { expect, test } from 'vitest'
import { announcedElsewhere } from './elsewhere.ts'

const answers = (body: unknown) => () => Promise.resolve(Response.json(body))
const byName = { hostname: 'laptop.fritz.box', origin: 'http://laptop.fritz.box:4173' }
const announced = { address: 'http://192.168.0.5:4173' }

test('a page under another name hears where it should be', async () =>
  expect(await announcedElsewhere(byName, answers(announced))).toBe('http://192.168.0.5:4173'))

test.each([
  ['the announced address', { hostname: '192.168.0.5', origin: 'http://192.168.0.5:4173' }],
  ['the machine of the server', { hostname: 'localhost', origin: 'http://localhost:4173' }],
])('%s is right', async (_where, at) => expect(await announcedElsewhere(at, answers(announced))).toBeNull())

test.each([
  ['a lab without a class', () => Promise.resolve(new Response(null, { status: 204 }))],
  ['a server that has ended', () => Promise.reject(new TypeError('Failed to fetch'))],
  ['a page that answers for everything', () => Promise.resolve(new Response('<html>'))],
  ['a server that knows no address', answers({ address: null })],
  ['an address that runs a script', answers({ address: 'javascript:alert(1)' })],
])('%s leads nowhere', async (_who, fetch) => expect(await announcedElsewhere(byName, fetch)).toBeNull())
