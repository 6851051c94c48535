import { existsSync, mkdirSync, readdirSync, statfsSync } from 'node:fs'
import { basename, resolve, sep } from 'node:path'
import { CannotServe, causeIn } from './problem.ts'

// Programs that copy a folder elsewhere copy a database while it is written, and children's work with it.
const synced: readonly (readonly [RegExp, string])[] = [
  [/^OneDrive( |$)/i, 'OneDrive'],
  [/^Dropbox( |$)/i, 'Dropbox'],
  [/^(iCloud ?Drive|Mobile Documents|com~apple~CloudDocs)$/i, 'iCloud'],
  [/^Google ?Drive$/i, 'Google Drive'],
  [/^(Nextcloud|ownCloud)$/i, 'Nextcloud'],
]

/** Kinds of file systems that Linux calls by number: NFS, SMB, CIFS, SMB2, 9P, FUSE of networks (sshfs). */
const ofNetworks = new Set([0x6969, 0x517b, 0xff534d42, 0xfe534d42, 0x01021997, 0x65735546])

/** The program that copies this folder elsewhere; null for none that is known. */
export function syncedBy(folder: string): string | null {
  const parts = resolve(folder).split(/[\\/]/)
  return synced.find(([name]) => parts.some((part) => name.test(part)))?.[1] ?? null
}

/** On a network drive databases break. */
export function isOnNetwork(folder: string): boolean {
  if (folder.startsWith('\\\\')) return true
  return process.platform === 'linux' && ofNetworks.has(statfsSync(folder).type)
}

/**
 * Makes the folder that holds all of a class server where it is missing.
 * @throws {CannotServe} where it is no place for a database: synced by a program, on a network, not to be written
 */
export function prepareDataFolder(folder: string): string {
  const path = resolve(folder)
  const by = syncedBy(path)
  if (by !== null) throw new CannotServe('syncedFolder', { path, by })
  try {
    mkdirSync(path, { recursive: true, mode: 0o700 })
  } catch (error) {
    throw new CannotServe('noFolder', { path, why: causeIn(error) })
  }
  if (isOnNetwork(path)) throw new CannotServe('networkFolder', { path })
  return path
}

/** A database that was broken and set aside, with nothing in its place yet; null for none. */
export function brokenIn(folder: string): string | null {
  if (existsSync(`${folder}${sep}botgarten.db`)) return null
  const aside = readdirSync(folder).filter((name) => /^botgarten\.db\.broken-\d+$/.test(basename(name)))
  return aside.length > 0 ? `${folder}${sep}${aside.toSorted().at(-1)}` : null
}
