import { content } from '@botgarten/content/files'
import { cardProject } from '@botgarten/content'
import { hasMessage } from '#words/message.ts'
import { afterAll, afterEach, beforeAll, describe, expect, test, vi } from 'vitest'
import { picture } from '../../../../../../e2e/png.ts'
import { floorPictureFrom } from './picture.ts'

afterEach(() => vi.unstubAllGlobals())

const { card, world, start } = content.card('friendship')!
const project = cardProject(world, card, start, 'A floor')

/** A PNG that says it is so big, with all its pieces in place. */
function huge(width: number, height: number): Buffer {
  const png = picture(8, 8)
  png.writeUInt32BE(width, 16)
  png.writeUInt32BE(height, 20)
  return png
}

const svg = '<svg xmlns="http://www.w3.org/2000/svg"><script>document.title = "!"</script></svg>'

test.each([
  ['big.png', huge(20_000, 20_000), 'pictureTooWide', { width: 20_000, height: 20_000, most: 10_000 }],
  ['high.png', huge(10, 10_001), 'pictureTooWide', { width: 10, height: 10_001, most: 10_000 }],
  ['diary.png', Buffer.from('Dear diary, today Bo drove'), 'pictureKind', {}],
  ['cut.png', picture(50, 50).subarray(0, 60), 'pictureBroken', {}],
  ['map.svg', Buffer.from(svg), 'pictureSvg', {}],
  ['heavy.png', Buffer.alloc(20_000_001), 'pictureTooHeavy', {}],
])('%s is no floor, and there are words for why', async (name, bytes, problem, facts) => {
  const file = new File([new Uint8Array(bytes)], name)
  expect(await floorPictureFrom(file, project)).toEqual({ problem, facts })
  for (const part of ['title', 'text']) expect(hasMessage(`problem.${problem}.${part}`)).toBe(true)
})

describe('a picture that its head allows', () => {
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

  const file = (width: number, height: number) => new File([new Uint8Array(huge(width, height))], 'floor.png')

  /** A browser that unpacks it, and whose canvas gives a picture of the canvas's size. */
  function drawing(bitmap: { readonly width: number; readonly height: number }) {
    const pen = { fillRect: vi.fn(), drawImage: vi.fn() }
    const createElement = () => {
      const canvas = { width: 0, height: 0, getContext: () => pen }
      const toBlob = (done: (blob: Blob) => void) =>
        done(new Blob([new Uint8Array(picture(canvas.width, canvas.height))]))
      return Object.assign(canvas, { toBlob })
    }
    vi.stubGlobal('createImageBitmap', () => Promise.resolve({ ...bitmap, close: () => {} }))
    vi.stubGlobal('document', { createElement })
  }

  test('is refused as broken where the browser cannot unpack it', async () => {
    vi.stubGlobal('createImageBitmap', () => Promise.reject(new Error('It cannot be decoded.')))
    expect(await floorPictureFrom(file(50, 50), project)).toEqual({ problem: 'pictureBroken', facts: {} })
  })

  test.each([
    // 1600 × 1200 at most, with its own sides: 3200 : 1200 is 1600 : 600, and 900 : 2400 is 450 : 1200.
    [3200, 1200, 1600, 600],
    [900, 2400, 450, 1200],
    [80, 60, 80, 60],
  ])('of %d × %d becomes a floor of %d × %d', async (width, height, wide, high) => {
    drawing({ width, height })
    const taken = await floorPictureFrom(file(width, height), project)
    expect(taken).toMatchObject({ picture: { width: wide, height: high } })
  })
})
