import { once } from 'node:events'
import { readFile } from 'node:fs/promises'
import { createServer, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join } from 'node:path'

/** What any web space knows. */
const types: { readonly [end: string]: string } = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.md': 'text/markdown',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain',
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
}

export interface WebSpace {
  /** Address of the folder, with a slash at its end. */
  readonly url: string
  /** Every path that was asked for and is not below the folder. */
  readonly outside: readonly string[]
  close(): Promise<void>
}

/**
 * Serves files as a plain web space does: a folder by its index.html, and nothing else by anything but its name.
 * @param path folder of the web space in which the files lie: `/schools/one/`
 * @param written what lies there besides: text by name
 */
export async function serveFolder(
  folder: string,
  path: string,
  written: { readonly [name: string]: string } = {},
): Promise<WebSpace> {
  const outside: string[] = []
  const server = createServer((request, response) => {
    const asked = decodeURIComponent((request.url ?? '/').replace(/[?#].*/, ''))
    if (!asked.startsWith(path)) {
      outside.push(asked)
      // Where a page names no icon, as a plain text cannot, the browser asks the root for one.
      return void response.writeHead(asked === '/favicon.ico' ? 204 : 404).end()
    }
    void answer(folder, asked.slice(path.length), written, response)
  })
  server.listen(0, '127.0.0.1')
  await once(server, 'listening')
  const { port } = server.address() as AddressInfo
  return {
    url: `http://localhost:${port}${path}`,
    outside,
    async close() {
      server.closeAllConnections()
      server.close()
      await once(server, 'close')
    },
  }
}

async function answer(
  folder: string,
  name: string,
  written: { readonly [name: string]: string },
  response: ServerResponse,
) {
  const file = name === '' || name.endsWith('/') ? `${name}index.html` : name
  const text = written[file] ?? (await readFile(join(folder, file)).catch(() => null))
  if (text !== null)
    return response.writeHead(200, { 'content-type': types[extname(file)] ?? 'text/plain' }).end(text)
  const isFolder = await readFile(join(folder, name, 'index.html')).then(
    () => true,
    () => false,
  )
  if (isFolder) response.writeHead(301, { location: `${name.split('/').at(-1)}/` }).end()
  else response.writeHead(404).end()
}
