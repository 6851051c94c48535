import { createHash } from 'node:crypto'
import type { ReadableStream } from 'node:stream/web'
import { createTarDecoder } from 'modern-tar'
import { decrypted, manifestName, parseManifest } from './sealed-file.ts'

/** Reads a part to its end. @param keep whether its text is wanted, too */
async function read(body: ReadableStream<Uint8Array>, keep: boolean) {
  const hash = createHash('sha256')
  const pieces: Uint8Array[] = []
  let bytes = 0
  for await (const piece of body) {
    hash.update(piece)
    bytes += piece.length
    if (keep) pieces.push(piece)
  }
  return { bytes, sha256: hash.digest('hex'), text: Buffer.concat(pieces).toString('utf8') }
}

interface Entry {
  readonly header: { readonly name: string }
  readonly body: ReadableStream<Uint8Array>
}

/**
 * Decrypts a backup from the disk and compares each part with the manifest, as a restore does; nothing is written.
 * @throws where the file is cut or changed
 */
export async function isReadable(file: string, phrase: string): Promise<boolean> {
  const archive = await decrypted(file, phrase)
  if (archive === null) return false
  const found = new Map<string, { readonly bytes: number; readonly sha256: string }>()
  let manifest: ReturnType<typeof parseManifest> = null
  const entries = (archive as globalThis.ReadableStream<Uint8Array>).pipeThrough(createTarDecoder())
  for await (const { header, body } of entries as ReadableStream<Entry>) {
    const { text, ...part } = await read(body, header.name === manifestName)
    if (header.name === manifestName) manifest = parseManifest(text)
    else found.set(header.name, part)
  }
  if (manifest === null) return false
  return manifest.parts.every(({ name, bytes, sha256 }) => {
    const copy = found.get(name)
    return copy?.bytes === bytes && copy.sha256 === sha256
  })
}
