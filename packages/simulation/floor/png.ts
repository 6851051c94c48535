import { convertIndexedToRgb, decode, type DecodedPng } from 'fast-png'
import { Unzlib } from 'fflate'
import { HIGHEST, WIDEST, type Picture } from './picture.ts'

/** notPng: something else · tooBig: more than 1600 × 1200, or more data than its size says · broken: cannot be read. */
export type FloorProblem = 'notPng' | 'tooBig' | 'broken'

export class FloorError extends Error {
  readonly problem: FloorProblem
  constructor(problem: FloorProblem) {
    super(`The floor's picture cannot be used: ${problem}`)
    this.problem = problem
  }
}

/**
 * Decodes a floor's PNG (8 bits a channel, or a palette); what is transparent becomes white. Sizes are looked at in the
 * header and the packed data is measured before anything is unpacked into memory.
 * @throws FloorError
 */
export function readPng(png: Uint8Array): Picture {
  const chunks = criticalChunks(png)
  checkSize(chunks)
  try {
    const image = decode(joined(chunks))
    return { width: image.width, height: image.height, data: toRgb(image) }
  } catch {
    throw new FloorError('broken')
  }
}

interface Chunk {
  readonly type: string
  /** Length, type, data and checksum. */
  readonly whole: Uint8Array
  readonly data: Uint8Array
}

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]
/** All others (text, colour profiles, animation) say nothing about colours here and could hide more data. */
const NEEDED = ['IHDR', 'PLTE', 'tRNS', 'IDAT', 'IEND']

function criticalChunks(png: Uint8Array): Chunk[] {
  if (SIGNATURE.some((byte, index) => png[index] !== byte)) throw new FloorError('notPng')
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength)
  const chunks: Chunk[] = []
  for (let at = SIGNATURE.length; at + 12 <= png.length;) {
    const end = at + 12 + view.getUint32(at)
    if (end > png.length) break
    const type = String.fromCharCode(...png.subarray(at + 4, at + 8))
    if (NEEDED.includes(type))
      chunks.push({ type, whole: png.subarray(at, end), data: png.subarray(at + 8, end - 4) })
    at = end
  }
  if (chunks[0]?.type !== 'IHDR' || chunks[0].data.length !== 13 || chunks.at(-1)?.type !== 'IEND')
    throw new FloorError('broken')
  return chunks
}

/** Channels by the PNG's colour type. */
const CHANNELS: { readonly [type: number]: number } = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 }

function checkSize(chunks: readonly Chunk[]): void {
  const header = chunks[0]!.data
  const view = new DataView(header.buffer, header.byteOffset, header.byteLength)
  const width = view.getUint32(0)
  const height = view.getUint32(4)
  if (width > WIDEST || height > HIGHEST) throw new FloorError('tooBig')
  const bits = header[8]! * (CHANNELS[header[9]!] ?? 0)
  if (width === 0 || height === 0 || bits === 0) throw new FloorError('broken')
  // Interlacing cuts rows into up to seven pieces, each with a byte in front.
  checkUnpacked(chunks, height * (Math.ceil((width * bits) / 8) + 16) + 64)
}

const PIECE = 4096

/** Unpacks in small pieces, keeping nothing, and stops when more comes out than the picture can need. */
function checkUnpacked(chunks: readonly Chunk[], most: number): void {
  let unpacked = 0
  const measure = new Unzlib((piece) => (unpacked += piece.length))
  for (const { type, data } of chunks) {
    if (type !== 'IDAT') continue
    for (let at = 0; at < data.length; at += PIECE) {
      try {
        measure.push(data.slice(at, at + PIECE))
      } catch {
        throw new FloorError('broken')
      }
      if (unpacked > most) throw new FloorError('tooBig')
    }
  }
}

function joined(chunks: readonly Chunk[]): Uint8Array {
  const length = chunks.reduce((sum, { whole }) => sum + whole.length, SIGNATURE.length)
  const png = new Uint8Array(length)
  png.set(SIGNATURE)
  let at = SIGNATURE.length
  for (const { whole } of chunks) {
    png.set(whole, at)
    at += whole.length
  }
  return png
}

function toRgb(image: DecodedPng): Uint8Array {
  const { data, channels } = unpacked(image)
  // As most are: a million points are as they should be.
  if (channels === 3) return data
  const rgb = new Uint8Array(image.width * image.height * 3)
  const isGrey = channels < 3
  const hasAlpha = channels === 2 || channels === 4
  for (let pixel = 0; pixel < image.width * image.height; pixel++) {
    const from = pixel * channels
    const alpha = hasAlpha ? data[from + channels - 1]! : 255
    for (let channel = 0; channel < 3; channel++) {
      const value = data[isGrey ? from : from + channel]!
      rgb[pixel * 3 + channel] = Math.round((value * alpha + 255 * (255 - alpha)) / 255)
    }
  }
  return rgb
}

function unpacked(image: DecodedPng): { data: Uint8Array; channels: number } {
  if (image.palette) return { data: convertIndexedToRgb(image), channels: image.palette[0]!.length }
  if (image.depth !== 8) throw new FloorError('broken')
  return { data: image.data as Uint8Array, channels: image.channels }
}
