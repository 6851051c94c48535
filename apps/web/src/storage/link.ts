import {
  parseProject,
  ProjectError,
  refusalOf,
  writeProject,
  type Project,
} from '@botgarten/programs/project'
import { Inflate, strFromU8, strToU8 } from 'fflate'

/** Why a link was refused, as the words `problem.<reason>.title` and `.text`. */
export type LinkReason = 'linkCut' | 'linkTooBig' | 'linkNewer' | 'linkNotAProject'

export class LinkError extends Error {
  override readonly name = 'LinkError'
  readonly reason: LinkReason

  constructor(reason: LinkReason) {
    super(`The link was refused: ${reason}`)
    this.reason = reason
  }
}

/** product.md 8: what is compressed has at most 8 kB. */
const mostBytes = 8000
/** Four letters carry three bytes; the version, the check and its two dots come before. */
const mostLetters = Math.ceil((mostBytes * 4) / 3) + 24
/** What may come out of it: more than a project of 8 kB can be, less than what makes a tablet slow. */
const mostUnpacked = 1_000_000
const version = '1'

/**
 * A project as the part of an address behind `#`: version, check of what follows, the project compressed.
 * Letters, digits, dots, - and _ alone, so that no program on the way changes it.
 * @returns null where it is too large for a link
 */
export async function writeLink({ progress: _progress, ...project }: Project): Promise<string | null> {
  const text = writeProject(project)
  if (refusalOf(project) || strToU8(text).length > mostUnpacked) return null
  const packed = await pack(text)
  if (packed.length > mostBytes) return null
  const letters = toLetters(packed)
  return `${version}.${checkOf(letters)}.${letters}`
}

/**
 * The project in a link. Nothing of it is trusted.
 * @param hash with or without its `#`
 * @throws {LinkError} and nothing else
 */
export function readLink(hash: string): Project {
  const text = hash.replace(/^#/, '')
  const newer = /^([2-9]|\d\d+)\./.test(text)
  if (newer) throw new LinkError('linkNewer')
  if (text.length > mostLetters) throw new LinkError('linkTooBig')
  const [, check, letters] = /^1\.(\w+)\.([\w-]+)$/.exec(text) ?? []
  if (check === undefined || letters === undefined || check !== checkOf(letters))
    throw new LinkError('linkCut')
  return projectIn(unpack(fromLetters(letters)))
}

function projectIn(text: string): Project {
  try {
    return parseProject(text)
  } catch (cause) {
    if (cause instanceof ProjectError) throw new LinkError('linkNotAProject')
    throw cause
  }
}

/** What the browser itself can do is not sent to it. */
async function pack(text: string): Promise<Uint8Array> {
  const packing = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'))
  return new Uint8Array(await new Response(packing).arrayBuffer())
}

/** Stops at the first byte too many: a few letters can hold a thousand times as much. */
function unpack(packed: Uint8Array): string {
  const parts: Uint8Array[] = []
  let length = 0
  const inflate = new Inflate((part) => {
    length += part.length
    if (length > mostUnpacked) throw new LinkError('linkTooBig')
    parts.push(part)
  })
  try {
    const step = 256
    for (let at = 0; at < packed.length; at += step)
      inflate.push(packed.subarray(at, at + step), at + step >= packed.length)
  } catch (cause) {
    throw cause instanceof LinkError ? cause : new LinkError('linkNotAProject')
  }
  const all = new Uint8Array(length)
  let at = 0
  for (const part of parts) {
    all.set(part, at)
    at += part.length
  }
  return strFromU8(all)
}

const toLetters = (bytes: Uint8Array): string =>
  btoa(strFromU8(bytes, true)).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')

function fromLetters(letters: string): Uint8Array {
  try {
    return strToU8(atob(letters.replaceAll('-', '+').replaceAll('_', '/')), true)
  } catch {
    throw new LinkError('linkCut')
  }
}

/** FNV-1a, 32 bits (http://www.isthe.com/chongo/tech/comp/fnv/): tells a link that was cut from a whole one. */
function checkOf(text: string): string {
  let hash = 0x811c9dc5
  for (let at = 0; at < text.length; at += 1) hash = Math.imul(hash ^ text.charCodeAt(at), 0x01000193)
  return (hash >>> 0).toString(36)
}
