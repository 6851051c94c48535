import { deflateSync } from 'node:zlib'
import { afterEach, expect, test, vi } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { pictureIn } from './pictures.ts'

afterEach(() => vi.unstubAllGlobals())

test('a floor of ours is unpacked from width, height and pixels; a colour is no picture', async () => {
  const bytes = new Uint8Array([0, 0, 1, 2, 0, 0, 0, 3, 9, 8, 7])
  const asked: unknown[] = []
  vi.stubGlobal('fetch', (address: unknown) => {
    asked.push(address)
    return Promise.resolve(new Response(deflateSync(bytes)))
  })
  expect(await pictureIn(friendship.world, undefined)).toEqual({
    ...{ width: 258, height: 3 },
    data: new Uint8Array([9, 8, 7]),
  })
  expect(asked).toHaveLength(1)
  expect(await pictureIn({ floor: { colour: '#FFFFFF' } }, undefined)).toBeNull()
  expect(asked).toHaveLength(1)
})

test('a picture of a child’s own that is none is refused', async () => {
  const own = { type: 'image/png', base64: 'AAAA' } as const
  await expect(pictureIn(friendship.world, own)).rejects.toThrow()
})
