// A backup in one file: a tar archive with a manifest, encrypted with a passphrase in the format of age
// (https://age-encryption.org/v1). `age -d FILE | tar -x` opens it without this program.
import { createHash } from 'node:crypto'
import { createReadStream, createWriteStream, existsSync, readFileSync, statSync } from 'node:fs'
import { open } from 'node:fs/promises'
import { basename, join } from 'node:path'
import { Readable } from 'node:stream'
import type { ReadableStream } from 'node:stream/web'
import { pipeline } from 'node:stream/promises'
import { Decrypter, Encrypter } from 'age-encryption'
import { packTar, unpackTar } from 'modern-tar/fs'
import * as v from 'valibot'
import { codeOf } from '../database/errors.ts'

/** The version that this program writes, and the latest that it reads. */
const current = 1
export const manifestName = 'manifest.json'
const mark = 'age-encryption.org/v1\n'

/**
 * 2^14 rounds of scrypt, 16 MB of memory: a Raspberry Pi has it, and a random passphrase of 90 bits needs no more.
 * age itself takes 2^18 since people choose their passphrases.
 */
const workFactor = 14

const name = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9.-]{0,60}$/))
const part = v.object({ name, bytes: v.number(), sha256: v.string() })
const manifestOf = v.object({
  format: v.literal('botgarten-backup'),
  /** Raised when a reader of before would lose something. */
  version: v.number(),
  /** ISO day of the server that made it. */
  day: v.string(),
  parts: v.array(part),
})
type Part = v.InferOutput<typeof part>

type Opened =
  | { readonly kind: 'opened'; readonly day: string; readonly names: readonly string[] }
  | { readonly kind: 'notABackup' | 'wrongPhrase' | 'damaged' | 'newer' }

async function hashOfFile(path: string): Promise<string> {
  const hash = createHash('sha256')
  for await (const piece of createReadStream(path)) hash.update(piece as Buffer)
  return hash.digest('hex')
}

async function partOf(path: string): Promise<Part> {
  return { name: basename(path), bytes: statSync(path).size, sha256: await hashOfFile(path) }
}

interface Sealing {
  /** ISO day for the manifest. */
  readonly day: string
  readonly phrase: string
  readonly version?: number
}

/** Packs files and encrypts them into a new file. Streams: large files take no more memory than small ones. */
export async function writeSealed(
  file: string,
  paths: readonly string[],
  { day, phrase, version = current }: Sealing,
): Promise<void> {
  const parts: Part[] = []
  for (const path of paths) parts.push(await partOf(path))
  const content = JSON.stringify({ format: 'botgarten-backup', version, day, parts }, null, 2)
  const mode = 0o600
  const archive = packTar([
    { type: 'content', content, target: manifestName, mode },
    ...paths.map((source) => ({ type: 'file' as const, source, target: basename(source), mode })),
  ])
  const encrypter = new Encrypter()
  encrypter.setPassphrase(phrase)
  encrypter.setScryptWorkFactor(workFactor)
  const sealed = await encrypter.encrypt(Readable.toWeb(archive) as globalThis.ReadableStream<Uint8Array>)
  await pipeline(Readable.fromWeb(sealed as ReadableStream), createWriteStream(file, { mode }))
}

/** Is a file encrypted by age? Reads its first line alone. */
export async function isSealed(file: string): Promise<boolean> {
  const opened = await open(file)
  try {
    const { buffer } = await opened.read(Buffer.alloc(mark.length), 0, mark.length, 0)
    return buffer.toString('latin1') === mark
  } finally {
    await opened.close()
  }
}

/** Null: the phrase is another one. @throws where the file is cut or was not encrypted with a passphrase */
export async function decrypted(file: string, phrase: string): Promise<ReadableStream | null> {
  const decrypter = new Decrypter()
  decrypter.addPassphrase(phrase)
  const source = Readable.toWeb(createReadStream(file)) as globalThis.ReadableStream<Uint8Array>
  try {
    return (await decrypter.decrypt(source)) as ReadableStream
  } catch (error) {
    await source.cancel().catch(() => undefined)
    if (error instanceof Error && error.message.startsWith('no identity matched')) return null
    throw error
  }
}

/**
 * Opens a backup into an empty folder and compares each part with the manifest. Only files with plain names are taken from
 * the archive.
 */
export async function openSealed(file: string, phrase: string, into: string): Promise<Opened> {
  if (!(await isSealed(file))) return { kind: 'notABackup' }
  try {
    const archive = await decrypted(file, phrase)
    if (archive === null) return { kind: 'wrongPhrase' }
    const isPart = (header: { name: string; type?: string }) =>
      header.type === 'file' && v.is(name, header.name)
    await pipeline(Readable.fromWeb(archive), unpackTar(into, { filter: isPart, fmode: 0o600 }))
  } catch (error) {
    // An error of the system, such as a full disk, does not mean that the backup is damaged.
    if (codeOf(error).startsWith('E')) throw error
    // Cut, or changed after it was made: age checks each piece of 64 kB and that the last one is present.
    return { kind: 'damaged' }
  }
  return await compare(into)
}

async function compare(folder: string): Promise<Opened> {
  const manifest = parseManifest(read(join(folder, manifestName)))
  if (manifest === null) return { kind: 'notABackup' }
  if (manifest.version > current) return { kind: 'newer' }
  for (const { name: called, bytes, sha256 } of manifest.parts) {
    const found = await partOf(join(folder, called)).catch(() => null)
    if (found?.bytes !== bytes || found.sha256 !== sha256) return { kind: 'damaged' }
  }
  return { kind: 'opened', day: manifest.day, names: manifest.parts.map((one) => one.name) }
}

const read = (path: string) => (existsSync(path) ? readFileSync(path, 'utf8') : '')

/** Version, day and parts of a backup; null for a text that is no manifest. */
export function parseManifest(text: string) {
  try {
    return v.parse(manifestOf, JSON.parse(text))
  } catch {
    return null
  }
}
