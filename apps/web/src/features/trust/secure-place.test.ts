import { expect, test } from 'vitest'
import { plainPlace, securePlace } from './secure-place.ts'

const answering =
  (body: string | null, status = 200) =>
  () =>
    Promise.resolve(new Response(body, { status }))

test('https is at the same host, at the port that the server names', async () =>
  expect(await securePlace('192.168.1.5', answering('{"port":4174}'))).toBe('https://192.168.1.5:4174'))

test.each([
  ['a server without https', answering(null, 204)],
  ['a lab of files', answering('Not found', 404)],
  ['a page that stands for all', answering('<!doctype html>')],
  ['another port', answering('{"port":"4174/evil"}')],
  ['no network', () => Promise.reject(new TypeError('fetch'))],
])('%s has no such place', async (_, fetch) => expect(await securePlace('localhost', fetch)).toBe(null))

const own = { hostname: 'localhost', origin: 'http://localhost:4173' }
const addresses = ['http://localhost:4173', 'https://192.168.1.5:4174', 'http://192.168.1.5:4173']

test('the sheet of the machine that serves leads others to plain http, where they do not need to trust yet', async () => {
  expect(await plainPlace(own, answering(JSON.stringify({ addresses })))).toBe('http://192.168.1.5:4173')
  expect(await plainPlace(own, answering(null, 204))).toBe(own.origin)
  expect(await plainPlace(own, () => Promise.reject(new TypeError('fetch')))).toBe(own.origin)
  const inRoom = { hostname: '192.168.1.5', origin: 'http://192.168.1.5:4173' }
  expect(await plainPlace(inRoom, answering('never asked', 500))).toBe(inRoom.origin)
})
