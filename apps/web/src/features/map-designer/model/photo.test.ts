import { afterAll, afterEach, beforeAll, describe, expect, test, vi } from 'vitest'
import { photoFrom, photoOfDrawing } from './photo.ts'

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

describe('a photo', () => {
  // Browsers have it, Node does not yet.
  const isKnown = 'toBase64' in Uint8Array.prototype
  beforeAll(() => {
    if (isKnown) return
    const value = function (this: Uint8Array) {
      return Buffer.from(this).toString('base64')
    }
    Object.defineProperty(Uint8Array.prototype, 'toBase64', { value, configurable: true })
  })
  afterAll(() => {
    if (!isKnown) Reflect.deleteProperty(Uint8Array.prototype, 'toBase64')
  })

  interface Drawn {
    readonly width: number
    readonly quality: number
    readonly at: readonly number[]
  }
  /** A browser's canvas: records each drawing, and writes files of `bytes(width, quality)` bytes. */
  function canvases(bytes: (width: number, quality: number) => number, type = 'image/jpeg'): Drawn[] {
    const drawn: Drawn[] = []
    const canvas = () => {
      let at: readonly number[] = []
      const pen = { fillRect: () => {}, drawImage: (_: unknown, ...where: number[]) => (at = where) }
      const made = {
        ...{ width: 0, height: 0, getContext: () => pen },
        toBlob(done: (blob: Blob) => void, _: string, quality: number) {
          drawn.push({ width: made.width, quality, at })
          done(new Blob([new Uint8Array(bytes(made.width, quality))], { type }))
        },
      }
      return made
    }
    vi.stubGlobal('document', { createElement: (name: string) => (name === 'canvas' ? canvas() : null) })
    return drawn
  }
  const bitmap = (width: number, height: number) =>
    vi.stubGlobal('createImageBitmap', () => Promise.resolve({ width, height, close: () => {} }))

  test('fills the paper, its middle in the middle', async () => {
    bitmap(3200, 1000)
    const drawn = canvases(() => 30)
    // 30 bytes are 40 letters of base64.
    expect(await photoFrom(gif(3200, 1000))).toEqual({ photo: 'A'.repeat(40) })
    // On 1600 × 1000 it is as high as the paper, and 800 stick out on both sides.
    expect(drawn).toEqual([{ width: 1600, quality: 0.8, at: [-800, 0, 3200, 1000] }])
  })

  test('becomes smaller until it fits, and is refused where it never does', async () => {
    bitmap(1600, 1000)
    // 600,000 letters of base64 are 450,000 bytes.
    const drawn = canvases((width) => (width > 800 ? 450_001 : 450_000))
    expect(await photoFrom(gif(1600, 1000))).toEqual({ photo: 'A'.repeat(600_000) })
    expect(drawn.map(({ width, quality }) => [width, quality])).toEqual([
      [1600, 0.8],
      [1600, 0.6],
      [1200, 0.6],
      [800, 0.5],
    ])
    canvases(() => 450_001)
    expect(await photoFrom(gif(1600, 1000))).toEqual({ problem: 'heavy' })
  })

  test('is none where the browser makes no JPEG', async () => {
    bitmap(1600, 1000)
    canvases(() => 30, 'image/png')
    expect(await photoFrom(gif(1600, 1000))).toEqual({ problem: 'heavy' })
  })

  test('of a drawing shows all of it', async () => {
    vi.stubGlobal('Image', class { src = ''; naturalWidth = 3200; naturalHeight = 1000; decode = () => Promise.resolve() }) // prettier-ignore
    const drawn = canvases(() => 30)
    await photoOfDrawing('<svg/>')
    // Half as large: 1600 × 500, with 250 above and below.
    expect(drawn[0]!.at).toEqual([0, 250, 1600, 500])
  })
})
