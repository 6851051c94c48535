import { X509Certificate } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { newAuthority, newLeaf, type Pair } from './certificates.ts'

const day = 86_400_000
/** A certificate is made anew when less of its time is left. */
const leastLeft = 30 * day

function readPair(folder: string, name: string): Pair | null {
  const [certificate, key] = [join(folder, `${name}.crt`), join(folder, `${name}.key`)]
  if (!existsSync(certificate) || !existsSync(key)) return null
  return { certificate: readFileSync(certificate, 'utf8'), key: readFileSync(key, 'utf8') }
}

function writePair(folder: string, name: string, { certificate, key }: Pair) {
  writeFileSync(join(folder, `${name}.key`), key, { mode: 0o600 })
  writeFileSync(join(folder, `${name}.crt`), certificate)
}

/** Does a certificate hold these names, and long enough? */
function serves({ certificate }: Pair, names: readonly string[], now: number): boolean {
  const { subjectAltName = '', validTo } = new X509Certificate(certificate)
  const held = subjectAltName.split(', ').map((name) => name.replace(/^(DNS|IP Address):/, ''))
  return names.every((name) => held.includes(name)) && Date.parse(validTo) - now > leastLeft
}

export interface Certificates extends Pair {
  /** The authority that devices are to trust, as PEM. */
  readonly authority: string
}

/**
 * Certificates of a data folder. The authority is made once: every device was told to trust it by hand; it is made anew
 * only when its two years are over. Its key is readable by its owner alone.
 * @param names host names and addresses of the server @param now ms since 1970
 */
export async function certificatesIn(
  data: string,
  names: readonly string[],
  now: number,
): Promise<Certificates> {
  const folder = join(data, 'https')
  mkdirSync(folder, { recursive: true, mode: 0o700 })
  let authority = readPair(folder, 'authority')
  let leaf = readPair(folder, 'server')
  if (!authority || !serves(authority, [], now)) {
    authority = await newAuthority(now)
    writePair(folder, 'authority', authority)
    leaf = null
  }
  if (!leaf || !serves(leaf, names, now)) {
    leaf = await newLeaf(authority, names, now)
    writePair(folder, 'server', leaf)
  }
  return { ...leaf, authority: authority.certificate }
}
