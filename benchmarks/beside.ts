import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import type { RunningServer } from '../scripts/server.ts'

/** The server of another checkout, which has been built. */
export async function serverOf(folder: string): Promise<RunningServer> {
  const { startServer } = (await import(
    pathToFileURL(join(folder, 'scripts', 'server.ts')).href
  )) as typeof import('../scripts/server.ts')
  return startServer({ port: 0, host: '127.0.0.1' })
}
