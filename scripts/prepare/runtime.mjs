import { spawnSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { inHouse } from './house.mjs'
import { Trouble } from './run.mjs'

/** From here on Node runs TypeScript by itself. */
const oldest = [22, 18]

/** @param {string} version as in process.versions.node */
export function isNewEnough(version) {
  const [major = 0, minor = 0] = version.split('.').map(Number)
  return major > oldest[0] || (major === oldest[0] && minor >= oldest[1])
}

function broughtAlong() {
  const platform = process.platform === 'win32' ? 'win' : process.platform
  const program = process.platform === 'win32' ? 'node.exe' : 'node'
  const path = inHouse('node_modules', `node-${platform}-${process.arch}`, 'bin', program)
  // A Linux without glibc has the file and cannot run it.
  return existsSync(path) && spawnSync(path, ['--version']).status === 0 ? path : null
}

/** The Node that runs the product: the one npm brought along, else the user's own when it is new enough. */
export function runtime() {
  const path = broughtAlong()
  if (path !== null) return path
  if (isNewEnough(process.versions.node)) return process.execPath
  throw new Trouble(
    `Botgarten brings no Node for ${process.platform} ${process.arch}, and yours is ${process.versions.node}. ` +
      `Please install Node ${oldest.join('.')} or newer from https://nodejs.org and try again.`,
  )
}
