import fc from 'fast-check'
import { expect, test } from 'vitest'
import { picture } from '../../../../e2e/png.ts'
import { readPictureHead } from './picture-file.ts'

const bytes = (hex: string) => new Uint8Array(Buffer.from(hex.replace(/\s/g, ''), 'hex'))
const of = (text: string) => new TextEncoder().encode(text)

const png = new Uint8Array(picture(7, 5))

// First bytes as the formats' own descriptions have them: JFIF with a frame of 20000 × 300; GIF89a 640 × 480;
// WebP: lossy 1600 × 1200, extended 400 × 300, lossless 16 × 9.
const jpeg = bytes(
  'ffd8 ffe0 0010 4a46494600 0101 00 0001 0001 0000 ffc0 0011 08 012c 4e20 03 011100 021101 031101',
)
const gif = bytes('474946383961 8002 e001 f70000')
const webpLossy = bytes('52494646 24000000 57454250 56503820 18000000 300100 9d012a 4006 b004 0000')
const webpWide = bytes('52494646 24000000 57454250 56503858 0a000000 10000000 8f0100 2b0100')
const webpLossless = bytes('52494646 24000000 57454250 5650384c 0d000000 2f 0f000200 00')

test.each([
  ['PNG', png, { type: 'png', width: 7, height: 5 }],
  ['JPEG', jpeg, { type: 'jpeg', width: 20000, height: 300 }],
  ['GIF', gif, { type: 'gif', width: 640, height: 480 }],
  ['WebP', webpLossy, { type: 'webp', width: 1600, height: 1200 }],
  ['WebP with parts', webpWide, { type: 'webp', width: 400, height: 300 }],
  ['WebP without loss', webpLossless, { type: 'webp', width: 16, height: 9 }],
])('a %s says its size', (_, file, head) => {
  expect(readPictureHead(file)).toEqual(head)
})

test.each([
  ['a text that is called a picture', of('Dear diary, today Bo drove'), 'kind'],
  ['nothing', new Uint8Array(0), 'kind'],
  [
    'an SVG',
    of('<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg"><script>1</script></svg>'),
    'svg',
  ],
  ['a PNG that was cut', png.subarray(0, png.length - 20), 'broken'],
  ['a PNG of no dots', Uint8Array.from(png, (byte, at) => (at >= 16 && at < 20 ? 0 : byte)), 'broken'],
  ['a JPEG without a frame', jpeg.subarray(0, 20), 'broken'],
  ['a GIF that was cut', gif.subarray(0, 7), 'broken'],
  ['a WebP that was cut', webpWide.subarray(0, 25), 'broken'],
])('%s is refused', (_, file, problem) => {
  expect(readPictureHead(file)).toBe(problem)
})

test('any bytes, and any change of good ones, are a size or a refusal, nothing else', () => {
  const known = ['kind', 'svg', 'broken']
  const file = fc.oneof(
    fc.uint8Array({ maxLength: 200 }),
    fc
      .tuple(fc.constantFrom(png, jpeg, gif, webpLossy, webpWide, webpLossless), fc.nat(60), fc.nat(255))
      .map(([good, at, value]) => Uint8Array.from(good, (byte, index) => (index === at ? value : byte))),
  )
  fc.assert(
    fc.property(file, (odd) => {
      const head = readPictureHead(odd)
      if (typeof head === 'string') expect(known).toContain(head)
      else expect(head.width * head.height).toBeGreaterThan(0)
    }),
    { numRuns: 500 },
  )
})
