import { readFile } from 'node:fs/promises'
import { deflateSync } from 'node:zlib'
import { readPng } from '@botgarten/simulation/png'

/** A picture's pixels (width, height, then R, G, B), deflated. */
export async function packedPixels(file: string): Promise<Buffer> {
  const { width, height, data } = readPng(await readFile(file))
  const size = Buffer.alloc(8)
  size.writeUInt32BE(width, 0)
  size.writeUInt32BE(height, 4)
  return deflateSync(Buffer.concat([size, data]), { level: 9 })
}
