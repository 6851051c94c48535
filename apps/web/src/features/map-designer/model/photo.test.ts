import { afterEach, expect, test, vi } from 'vitest'
import { photoFrom } from './photo.ts'

afterEach(() => void vi.unstubAllGlobals())

const fileOf = (...parts: (string | Uint8Array<ArrayBuffer>)[]) => new File(parts, 'photo')
/** The header of a GIF with its size in pixels. */
function gif(width: number, height: number): File {
  const head = new Uint8Array(10)
  head.set([...'GIF89a'].map((letter) => letter.charCodeAt(0)))
  new DataView(head.buffer).setUint16(6, width, true)
  new DataView(head.buffer).setUint16(8, height, true)
  return fileOf(head)
}

test.each([
  ['a text', fileOf('hello'), 'kind'],
  ['a drawing that may hold a program', fileOf('<svg xmlns="x"></svg>'), 'svg'],
  ['a picture that was cut off', fileOf(new Uint8Array([0xff, 0xd8, 0xff])), 'broken'],
  ['a picture with a side of 10,001 dots', gif(10_001, 20), 'wide'],
  ['a picture with a height of 10,001 dots', gif(20, 10_001), 'wide'],
  ['a file of more than 20 MB', fileOf(new Uint8Array(20_000_001)), 'heavy'],
])('%s is not unpacked', async (_, file, problem) => {
  expect(await photoFrom(file)).toEqual({ problem })
})

test('a picture that the browser cannot unpack is broken', async () => {
  vi.stubGlobal('createImageBitmap', () => Promise.reject(new Error('Broken.')))
  expect(await photoFrom(gif(10_000, 10_000))).toEqual({ problem: 'broken' })
})
