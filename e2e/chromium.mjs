import { spawnSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { createRequire } from 'node:module'
import { delimiter, join } from 'node:path'
import { run, Trouble } from '../scripts/prepare/run.mjs'

// Asked for late: `npm test` imports this file before anything is installed.
const require = createRequire(import.meta.url)

const commands = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome']
const macApps = ['Google Chrome', 'Chromium', 'Microsoft Edge']
const windowsPrograms = [
  'Google\\Chrome\\Application\\chrome.exe',
  'Microsoft\\Edge\\Application\\msedge.exe',
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

function playwrightsOwn() {
  return require('@playwright/test').chromium.executablePath()
}

// Some systems put a signpost to an app store where the program is expected. On Windows `--version` opens a window.
const runs = (path) =>
  existsSync(path) && (process.platform !== 'linux' || spawnSync(path, ['--version']).status === 0)

/** @returns {string | null} a Chromium of this machine; `CHROMIUM` in the environment is taken at its word */
export function findChromium() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM
  return [...usualPlaces(process.platform, process.env), playwrightsOwn()].find(runs) ?? null
}

async function install() {
  if (process.getuid?.() === 0 && existsSync('/usr/bin/apt-get')) {
    const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' }
    const wait = ['-o', 'DPkg::Lock::Timeout=300']
    await run('apt-get', [...wait, 'update', '-qq'], { env })
    await run('apt-get', [...wait, 'install', '-y', '-qq', 'chromium'], { env })
    if (findChromium() !== null) return
  }
  const cli = require.resolve('@playwright/test/cli')
  await run(process.execPath, [cli, 'install', 'chromium'])
}

/** A Chromium, installed the way this machine allows where there is none. @returns {Promise<string>} */
export async function ensureChromium() {
  const found = findChromium()
  if (found !== null) return found
  console.log('No Chromium here: installing one …')
  await install()
  const installed = findChromium()
  if (installed !== null) return installed
  throw new Trouble(
    'No Chromium found: install Chrome or Chromium, or say where one is: CHROMIUM=/path/to/chrome npm test',
  )
}
