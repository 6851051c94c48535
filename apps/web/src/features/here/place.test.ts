import { expect, test } from 'vitest'
import { placeHere } from './place.ts'

const answers = (response: Response) => () => Promise.resolve(response)
const place = {
  announced: 'http://192.168.0.5:4173',
  folder: '/home/weber/.local/share/botgarten',
  otherDevice: null,
}

test('the machine that serves hears how it is reached, and where things lie', async () => {
  expect(await placeHere(answers(Response.json(place)))).toEqual(place)
})

test('the page requests the address that the server answers', async () => {
  const asked: string[] = []
  await placeHere((path) => (asked.push(path), Promise.resolve(Response.json(place))))
  // packages/server/server.ts answers there.
  expect(asked).toEqual(['/here.json'])
})

test.each([
  ['another machine', answers(new Response(null, { status: 204 }))],
  ['a lab of files', answers(new Response('<html>', { status: 200 }))],
  ['a server that has ended', () => Promise.reject(new TypeError('Failed to fetch'))],
  ['something else', answers(Response.json({ announced: 'none' }))],
])('%s hears nothing', async (_who, fetch) => expect(await placeHere(fetch)).toBe(null))
