// Runs on any Node from 20.19 on: `npm test` asks it before anything is installed.
import { spawnSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { delimiter, join } from 'node:path'

// Without windows of its own Chromium takes a fifth of the time less.
const commands = [
  'chromium-headless-shell',
  'chromium',
  'chromium-browser',
  'google-chrome',
  'google-chrome-stable',
  'chrome',
]
const macApps = ['Google Chrome', 'Chromium', 'Microsoft Edge']
const windowsPrograms = [
  'Google\\Chrome\\Application\\chrome.exe',
  'Microsoft\\Edge\\Application\\msedge.exe',
]

/** What a Chromium needs to run in a container, and to talk to nobody but us. */
export const flags = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
]

/**
 * Where a Chromium usually lies, best first.
 * @param {NodeJS.Platform} platform
 * @param {NodeJS.ProcessEnv} env
 * @returns {string[]}
 */
export function usualPlaces(platform, env) {
  if (platform === 'darwin') {
    const folders = ['/Applications', `${env.HOME}/Applications`]
    return folders.flatMap((folder) => macApps.map((app) => `${folder}/${app}.app/Contents/MacOS/${app}`))
  }
  if (platform === 'win32') {
    const folders = [env.PROGRAMFILES, env['PROGRAMFILES(X86)'], env.LOCALAPPDATA].filter((folder) => folder)
    return folders.flatMap((folder) => windowsPrograms.map((program) => `${folder}\\${program}`))
  }
  const folders = [...new Set([...(env.PATH ?? '').split(delimiter), '/usr/bin', '/snap/bin'])].filter(
    (f) => f,
  )
  return commands.flatMap((command) => folders.map((folder) => join(folder, command)))
}

// Some systems put a signpost to an app store where the program is expected. On Windows `--version` opens a window.
const runs = (path) =>
  existsSync(path) && (process.platform !== 'linux' || spawnSync(path, ['--version']).status === 0)

/**
 * A Chromium of this machine; `CHROMIUM` in the environment is taken at its word.
 * @param {readonly string[]} [otherPlaces] looked at last
 * @returns {string | null}
 */
export function findChromium(otherPlaces = []) {
  if (process.env.CHROMIUM) return process.env.CHROMIUM
  return [...usualPlaces(process.platform, process.env), ...otherPlaces].find(runs) ?? null
}
