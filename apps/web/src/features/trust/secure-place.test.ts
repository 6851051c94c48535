import { expect, test } from 'vitest'
import { securePlace } from './secure-place.ts'

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
