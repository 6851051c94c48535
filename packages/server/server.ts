import { once } from 'node:events'
import { createServer } from 'node:http'
import type { IncomingMessage, Server, ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { networkInterfaces } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { addresses } from './addresses.ts'
import { readOperator } from './operator.ts'
import { baseline, readPolicies } from './policies.ts'
import type { ClassServer } from './class-server.ts'
import { inRepository } from './repository.ts'

type Handler = (request: IncomingMessage, response: ServerResponse, next: () => void) => void

export interface RunningServer {
  readonly port: number
  /** How this machine reaches it. */
  readonly url: string
  /** Answers what was asked already, then lets go of the port. */
  close(): Promise<void>
}

export interface ServerOptions {
  /** 0: any free one. */
  readonly port: number
  /** All addresses of the machine where none is named. */
  readonly host?: string
  /** The imprint of who runs the lab; read from a file where it is not given. */
  readonly operator?: string | null
  /** Answers below `/api/class`, and is closed with the server. Where it is missing the lab is served alone. */
  readonly classServer?: ClassServer | null
}

const timeout = 3000

async function handlerOf(build: string): Promise<Handler> {
  const path = pathToFileURL(join(build, 'server', 'handler.js')).href
  return ((await import(path)) as { handler: Handler }).handler
}

/** What no page of the lab asks for, nor anything that it may ever hold in a frame. */
const unused = [
  'camera',
  'microphone',
  'geolocation',
  'display-capture',
  'payment',
  'usb',
  'serial',
  'bluetooth',
]
const permissions = [...unused, 'hid', 'midi'].map((name) => `${name}=()`).join(', ')

/** What every answer carries. SvelteKit replaces the policy on pages it renders, and the caching of what has a hash in its name. */
function dress(response: ServerResponse, policy: string, trusted: boolean) {
  response.setHeader('content-security-policy', policy)
  response.setHeader('x-content-type-options', 'nosniff')
  response.setHeader('referrer-policy', 'same-origin')
  response.setHeader('permissions-policy', permissions)
  // A page of somebody else that opened the lab has no hold on its window; the presenter's window is our own. Browsers
  // ignore this over plain http and complain about it.
  if (trusted) response.setHeader('cross-origin-opener-policy', 'same-origin')
  response.setHeader('cache-control', 'no-cache')
}

/** Does the browser trust the page's origin: the machine itself, or https through a proxy? */
const isTrusted = ({ headers }: IncomingMessage) =>
  headers['x-forwarded-proto'] === 'https' ||
  /^(localhost|127(\.\d+){3}|\[::1\])(:\d+)?$/.test(headers.host ?? '')

async function close(server: Server) {
  const closed = once(server, 'close')
  server.close()
  const timer = setTimeout(() => server.closeAllConnections(), timeout)
  await closed
  clearTimeout(timer)
}

async function closeAll(server: Server, classServer: ClassServer | null) {
  // Streams would go on for as long as their pages are open.
  await classServer?.ports.live.close()
  await close(server)
  await classServer?.close()
}

/**
 * Serves the built web app.
 * @throws the error of `listen`, with its `code` (EADDRINUSE …)
 */
export async function startServer(options: ServerOptions): Promise<RunningServer> {
  const build = inRepository('apps', 'web', 'build')
  const [handler, policies] = [await handlerOf(build), readPolicies(join(build, 'prerendered'))]
  const { operator = readOperator(process.env), classServer = null } = options
  const server = createServer((request, response) => {
    const path = (request.url ?? '/').replace(/[?#].*/, '').replace(/(?<=.)\/$/, '')
    dress(response, policies.get(path) ?? baseline, isTrusted(request))
    if (classServer?.owns(path)) return void classServer.answer(request, response)
    // Whether there is a class is asked by every page: no is an answer, not an error.
    if (path === '/api/class/state') return void response.writeHead(204).end()
    if (operator !== null && path === '/operator.md')
      return void response.setHeader('content-type', 'text/markdown; charset=utf-8').end(operator)
    handler(request, response, () => response.writeHead(404).end())
  })
  server.listen({ port: options.port, host: options.host })
  await once(server, 'listening')
  const { port } = server.address() as AddressInfo
  classServer?.reachedAt(() => addresses(port, networkInterfaces()))
  return { port, url: `http://localhost:${port}`, close: () => closeAll(server, classServer) }
}
