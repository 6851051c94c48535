import { cpSync } from 'node:fs'
import { join } from 'node:path'
import { inHouse } from '../prepare/house.mjs'
import { needsInstall } from '../prepare/install.mjs'
import { npm, Trouble } from '../prepare/run.mjs'

/** Installs the Nodes of all systems, whatever the system here is; the lock file says which bytes they have. */
export async function installNodes(): Promise<string> {
  const folder = inHouse('build', 'zips-nodes')
  cpSync(inHouse('scripts', 'zips', 'nodes'), folder, { recursive: true, preserveTimestamps: true })
  if (needsInstall(folder)) {
    console.log('Fetching Node for all systems …')
    const code = await npm(['ci', '--force', '--ignore-scripts', '--loglevel=error'], { cwd: folder })
    if (code !== 0) throw new Trouble('npm could not fetch the Nodes; what npm said stands above.')
  }
  return join(folder, 'node_modules')
}
