import { crc32, deflateSync } from 'node:zlib'

/** The colour of all of a `picture`, as a canvas says it. */
export const grey = '200,200,200,255'

/** A PNG of three bytes a dot, black in its upper left corner and light everywhere else. */
export function picture(width: number, height: number): Buffer {
  const rows = Buffer.alloc(height * (1 + width * 3), 200)
  for (let row = 0; row < height; row += 1) rows[row * (1 + width * 3)] = 0
  rows.fill(0, 0, 1 + width)
  const head = Buffer.alloc(13)
  head.writeUInt32BE(width, 0)
  head.writeUInt32BE(height, 4)
  head.set([8, 2], 8)
  const pieces = [piece('IHDR', head), piece('IDAT', deflateSync(rows)), piece('IEND', Buffer.alloc(0))]
  return Buffer.concat([Buffer.from('89504e470d0a1a0a', 'hex'), ...pieces])
}

function piece(type: string, data: Buffer): Buffer {
  const named = Buffer.concat([Buffer.from(type), data])
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)]
  length.writeUInt32BE(data.length)
  sum.writeUInt32BE(crc32(named))
  return Buffer.concat([length, named, sum])
}
