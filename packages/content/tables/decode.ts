import { TableError, type Encoding } from './types.ts'

/** How files of spreadsheets begin that are no text: xlsx and ods (a ZIP), xls. */
const spreadsheets = [
  [0x50, 0x4b, 0x03, 0x04],
  [0xd0, 0xcf, 0x11, 0xe0],
]

/**
 * The text of a file as spreadsheets save it: UTF-8, else Windows-1252; UTF-16 by its mark, or where every second byte of
 * its beginning is 0.
 * @throws TableError for a spreadsheet that was not saved as text
 */
export function decodeTable(bytes: Uint8Array): { readonly text: string; readonly encoding: Encoding } {
  if (spreadsheets.some((start) => start.every((byte, index) => bytes[index] === byte)))
    throw new TableError('spreadsheet', {})
  const encoding = encodingOf(bytes)
  return { text: new TextDecoder(encoding).decode(bytes), encoding }
}

function encodingOf(bytes: Uint8Array): Encoding {
  const [a, b] = bytes
  if (a === 0xff && b === 0xfe) return 'utf-16le'
  if (a === 0xfe && b === 0xff) return 'utf-16be'
  const start = bytes.subarray(0, Math.min(64, bytes.length - (bytes.length % 2)))
  const zeros = (odd: number) =>
    start.length > 0 && start.every((byte, at) => (at % 2 === odd) === (byte === 0))
  if (zeros(1)) return 'utf-16le'
  if (zeros(0)) return 'utf-16be'
  try {
    new TextDecoder('utf-8', { fatal: true }).decode(bytes)
    return 'utf-8'
  } catch {
    return 'windows-1252'
  }
}
