import { expect, test } from 'vitest'
import { placeHere } from './place.ts'

const place = {
  addresses: ['http://localhost:4173', 'http://192.168.0.5:4173'],
  folder: '/home/weber/.local/share/botgarten',
  otherDevice: null,
}

test('the machine that serves hears how it is reached, and where things lie', async () => {
  expect(await placeHere(async () => Response.json(place))).toEqual(place)
})

test.each([
  ['another machine', async () => new Response(null, { status: 204 })],
  ['a lab of files', async () => new Response('<html>', { status: 200 })],
  ['a server that has ended', () => Promise.reject(new TypeError('Failed to fetch'))],
  ['something else', async () => Response.json({ addresses: 'none' })],
])('%s hears nothing', async (_who, fetch) => expect(await placeHere(fetch)).toBe(null))
