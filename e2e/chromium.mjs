import { existsSync } from 'node:fs'
import { createRequire } from 'node:module'
import { findChromium as findInstalled } from '../packages/chromium/index.mjs'
import { run, Trouble } from '../scripts/prepare/run.mjs'

// Asked for late: `npm test` imports this file before anything is installed.
const require = createRequire(import.meta.url)

function playwrightsOwn() {
  return require('@playwright/test').chromium.executablePath()
}

/** @returns {string | null} a Chromium of this machine; `CHROMIUM` in the environment is taken at its word */
export const findChromium = () => findInstalled([playwrightsOwn()])

async function install() {
  if (process.getuid?.() === 0 && existsSync('/usr/bin/apt-get')) {
    const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' }
    const wait = ['-o', 'DPkg::Lock::Timeout=300']
    await run('apt-get', [...wait, 'update', '-qq'], { env })
    for (const name of ['chromium-headless-shell', 'chromium']) {
      await run('apt-get', [...wait, 'install', '-y', '-qq', name], { env })
      if (findChromium() !== null) return
    }
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
