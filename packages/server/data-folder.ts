import { accessSync, constants, existsSync, mkdirSync, readdirSync, statfsSync } from 'node:fs'
import { join, resolve } from 'node:path'
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
 * @throws {CannotServe} where it is no place for a database: synced by a program, on a network, read-only
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
  refuseReadOnly(path)
  if (isOnNetwork(path)) throw new CannotServe('networkFolder', { path })
  return path
}

/** @throws {CannotServe} if nothing can be written into the folder: the disk is read-only, or the rights are missing */
function refuseReadOnly(path: string): void {
  try {
    accessSync(path, constants.W_OK)
  } catch (error) {
    throw new CannotServe('readOnlyFolder', { path, why: causeIn(error) })
  }
}

/** The databases of a folder: the lab's, and the answers to questionnaires. */
const databases = ['botgarten.db', 'answers.db']

/** A database that was broken and set aside, with nothing in its place yet; null for none. */
export function brokenIn(folder: string): string | null {
  for (const name of databases.filter((one) => !existsSync(join(folder, one)))) {
    const asides = readdirSync(folder).filter((one) => /^\.broken-\d+$/.test(one.replace(name, '')))
    const newest = asides.toSorted(byNumber).at(-1)
    if (newest !== undefined) return join(folder, newest)
  }
  return null
}

const numberOf = (name: string) => Number(name.split('-').at(-1))
const byNumber = (one: string, other: string) => numberOf(one) - numberOf(other)
