/** What a picture file says about itself before anybody unpacks it: in dots. */
export interface PictureHead {
  readonly type: 'png' | 'jpeg' | 'gif' | 'webp'
  readonly width: number
  readonly height: number
}

/** `kind`: none of ours · `svg`: may hold a program · `broken`: ends too early or says no size. */
export type HeadProblem = 'kind' | 'svg' | 'broken'

const text = (bytes: Uint8Array, from: number, length: number) =>
  String.fromCharCode(...bytes.subarray(from, from + length))

/** Reads kind and size from the first bytes, whatever the file is called. */
export function readPictureHead(bytes: Uint8Array): PictureHead | HeadProblem {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  try {
    const size = sizeOf(bytes, view)
    if (typeof size === 'string') return size
    return size.width > 0 && size.height > 0 ? size : 'broken'
  } catch (error) {
    // The view ends before what should be read.
    if (error instanceof RangeError) return 'broken'
    throw error
  }
}

function sizeOf(bytes: Uint8Array, view: DataView): PictureHead | HeadProblem {
  if (text(bytes, 0, 4) === '\x89PNG') return png(bytes, view)
  if (text(bytes, 0, 3) === '\xff\xd8\xff') return jpeg(view)
  if (/^GIF8[79]a$/.test(text(bytes, 0, 6)))
    return { type: 'gif', width: view.getUint16(6, true), height: view.getUint16(8, true) }
  if (text(bytes, 0, 4) === 'RIFF' && text(bytes, 8, 4) === 'WEBP') return webp(bytes, view)
  return /<svg[\s>]|<!DOCTYPE svg/i.test(text(bytes, 0, 4096)) ? 'svg' : 'kind'
}

/** Looks through all its pieces: a browser would show half of a PNG that was cut. */
function png(bytes: Uint8Array, view: DataView): PictureHead | 'broken' {
  for (let at = 8; at + 12 <= bytes.length; at += 12 + view.getUint32(at))
    if (text(bytes, at + 4, 4) === 'IEND')
      return { type: 'png', width: view.getUint32(16), height: view.getUint32(20) }
  return 'broken'
}

/** Goes from marker to marker up to the one that begins a frame. */
function jpeg(view: DataView): PictureHead | 'broken' {
  for (let at = 2; at + 4 <= view.byteLength; at += 2 + view.getUint16(at + 2)) {
    const marker = view.getUint16(at)
    const isFrame = marker >= 0xffc0 && marker <= 0xffcf && ![0xffc4, 0xffc8, 0xffcc].includes(marker)
    if (isFrame) return { type: 'jpeg', width: view.getUint16(at + 7), height: view.getUint16(at + 5) }
    if (marker >> 8 !== 0xff) return 'broken'
  }
  return 'broken'
}

function webp(bytes: Uint8Array, view: DataView): PictureHead | 'broken' {
  const of = (width: number, height: number): PictureHead => ({ type: 'webp', width, height })
  const three = (at: number) => view.getUint16(at, true) + view.getUint8(at + 2) * 65536
  switch (text(bytes, 12, 4)) {
    case 'VP8X':
      return of(three(24) + 1, three(27) + 1)
    case 'VP8 ':
      return of(view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff)
    case 'VP8L': {
      const bits = view.getUint32(21, true)
      return of((bits & 0x3fff) + 1, ((bits >>> 14) & 0x3fff) + 1)
    }
    default:
      return 'broken'
  }
}
