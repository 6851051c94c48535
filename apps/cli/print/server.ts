import { once } from 'node:events'
import { existsSync } from 'node:fs'
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { FileError } from '../errors.ts'

type Handler = (request: IncomingMessage, response: ServerResponse, next: () => void) => void

export interface BuiltLab {
  readonly url: string
  close(): void
}

const built = join(import.meta.dirname, '../../web/build/server/handler.js')

/** Serves the built lab to this machine alone, on a free port. @throws FileError where it is not built */
export async function startServer(): Promise<BuiltLab> {
  if (!existsSync(built)) throw new FileError('file.notBuilt')
  const { handler } = (await import(pathToFileURL(built).href)) as { handler: Handler }
  const server = createServer((request, response) =>
    handler(request, response, () => response.writeHead(404).end()),
  )
  server.listen(0, '127.0.0.1')
  await once(server, 'listening')
  const close = () => {
    server.close()
    server.closeAllConnections()
  }
  return { url: `http://127.0.0.1:${(server.address() as AddressInfo).port}`, close }
}
