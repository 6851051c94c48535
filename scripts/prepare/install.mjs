import { createHash } from 'node:crypto'
import { existsSync, readFileSync, statSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { house } from './house.mjs'
import { npm, Trouble } from './run.mjs'

const lockOf = (folder) => join(folder, 'package-lock.json')
// npm writes this file last: a broken-off install has none.
const installedOf = (folder) => join(folder, 'node_modules', '.package-lock.json')
const stampOf = (folder) => join(folder, 'node_modules', '.botgarten-lock')
const hashOfLock = (folder) =>
  createHash('sha256')
    .update(readFileSync(lockOf(folder)))
    .digest('hex')

/**
 * Is node_modules missing, or older than the lock file? A lock file that was only touched is not newer.
 * @param {string} folder
 */
export function needsInstall(folder) {
  if (!existsSync(installedOf(folder))) return true
  const stamp = stampOf(folder)
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === hashOfLock(folder)) return false
  return statSync(installedOf(folder)).mtimeMs < statSync(lockOf(folder)).mtimeMs
}

// Windows cannot delete the node.exe that runs us, and `npm ci` begins by deleting.
const verb = () => (process.platform === 'win32' && existsSync(installedOf(house)) ? 'install' : 'ci')

/** Installs what package-lock.json names, when that is needed. */
export async function installWhenNeeded() {
  if (!needsInstall(house)) return
  console.log('Installing what Botgarten stands on (once, about a minute) …')
  const code = await npm([verb(), '--include=dev', '--include=optional', '--loglevel=error'])
  if (code !== 0) throw new Trouble('npm could not install the packages; what npm said stands above.')
  writeFileSync(stampOf(house), hashOfLock(house))
}
