import { once } from 'node:events'
import { createServer } from 'node:http'
import type { IncomingMessage, Server, ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { networkInterfaces } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { addresses, listenedAt, secureAddresses } from './addresses.ts'
import { announcedTo } from './announced.ts'
import { answerHere, type Here } from './here.ts'
import { startSecure, type SecureServer } from './https/secure-server.ts'
import { spreadConnections } from './pacing.ts'
import { readOperator } from './operator.ts'
import { baseline, readPolicies, transportOf } from './policies.ts'
import type { ClassServer } from './class-server.ts'
import { inRepository } from './repository.ts'

type Handler = (request: IncomingMessage, response: ServerResponse, next: () => void) => void

export interface RunningServer {
  readonly port: number
  /** How this machine reaches it. */
  readonly url: string
  /** Where it listens for https; null: it does not. */
  readonly securePort: number | null
  /** How it is reached, this machine's own name first; https before http elsewhere. */
  addresses(): readonly string[]
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
  /** The data folder with an authority of its own, whose certificates the next port answers https with. */
  readonly https?: string | null
}

const timeout = 3000

/**
 * Pages whose window another page that opened them has no hold on. For the others a browser would throw the process away
 * that it has ready, and their scripts come a tenth of a second later. Browsers ignore this over plain http and complain.
 */
const ofTeacher = /^\/teacher(\/|$)/

async function handlerOf(build: string): Promise<Handler> {
  const path = pathToFileURL(join(build, 'server', 'handler.js')).href
  return ((await import(path)) as { handler: Handler }).handler
}

/** What no page of the lab asks for, nor anything that it may ever hold in a frame. */
const unused = ['camera', 'microphone', 'geolocation', 'display-capture', 'payment', 'usb', 'serial']
const permissions = [...unused, 'hid', 'midi'].map((name) => `${name}=()`).join(', ')

/** What every answer carries. SvelteKit replaces the policy on pages it renders, and the caching of what has a hash in its name. */
function dress(response: ServerResponse, policy: string, alone: boolean) {
  response.setHeader('content-security-policy', policy)
  response.setHeader('x-content-type-options', 'nosniff')
  response.setHeader('referrer-policy', 'same-origin')
  response.setHeader('permissions-policy', permissions)
  if (alone) response.setHeader('cross-origin-opener-policy', 'same-origin')
  response.setHeader('cache-control', 'no-cache')
}

/** Does the browser trust the page's origin: the machine itself, https, or https through a proxy? */
const isTrusted = ({ headers, socket }: IncomingMessage) =>
  'encrypted' in socket ||
  headers['x-forwarded-proto'] === 'https' ||
  /^(localhost|127(\.\d+){3}|\[::1\])(:\d+)?$/.test(headers.host ?? '')

async function close(server: Server | SecureServer['server']) {
  // One that is closed already would never say so again.
  if (!server.listening) return
  const closed = once(server, 'close')
  server.close()
  const timer = setTimeout(() => server.closeAllConnections(), timeout)
  await closed
  clearTimeout(timer)
}

async function closeAll(server: Server, secure: SecureServer | null, classServer: ClassServer | null) {
  // Streams would go on for as long as their pages are open.
  await classServer?.ports.live.close()
  secure?.stop()
  await Promise.all([close(server), secure && close(secure.server)])
  await classServer?.close()
}

/** What a page asks to find the server's https: its port, or nothing where there is none. */
function answerHttps(secure: SecureServer | null, response: ServerResponse) {
  if (!secure) return void response.writeHead(204).end()
  response.setHeader('content-type', 'application/json').end(JSON.stringify({ port: secure.port }))
}

/** Under this type Windows, macOS, iPadOS and Android offer to install it. */
function sendAuthority(secure: SecureServer, response: ServerResponse) {
  response.setHeader('content-type', 'application/x-x509-ca-cert').end(secure.authority())
}

/** Plain http keeps its port: that is where devices learn to trust the other one. */
const nextPort = ({ port }: ServerOptions) => (port === 0 ? 0 : port + 1)

function allAddresses(port: number, securePort: number | null, host?: string): readonly string[] {
  const interfaces = listenedAt(networkInterfaces(), host)
  const [own, ...others] = addresses(port, interfaces)
  const secure = securePort === null ? [] : secureAddresses(securePort, interfaces)
  return [own!, ...secure, ...others]
}

/**
 * Serves the built web app.
 * @throws the error of `listen`, with its `code` (EADDRINUSE …)
 */
export async function startServer(options: ServerOptions): Promise<RunningServer> {
  const build = inRepository('apps', 'web', 'build')
  const [handler, policies] = [await handlerOf(build), readPolicies(join(build, 'prerendered'))]
  const { operator = readOperator(process.env), classServer = null } = options
  const publicOrigin = classServer?.ports.publicOrigin ?? null
  let secure: SecureServer | null = null
  const here = (): Here => ({
    addresses: reached(),
    announced: announcedTo(null, { publicAddress: null, proxied: false, addresses: reached }),
    ...{ folder: null, otherDevice: null },
    ...classServer?.place(),
  })
  const listener = (request: IncomingMessage, response: ServerResponse) => {
    const path = (request.url ?? '/').replace(/[?#].*/, '').replace(/(?<=.)\/$/, '')
    const transport = transportOf(publicOrigin, request.headers['x-forwarded-proto'])
    if (transport !== null) response.setHeader('strict-transport-security', transport)
    dress(response, policies.get(path) ?? baseline, ofTeacher.test(path) && isTrusted(request))
    if (classServer?.owns(path)) return void classServer.answer(request, response)
    // Whether there is a class is asked by every page: no is an answer, not an error.
    if (path === '/api/class/state') return void response.writeHead(204).end()
    if (path === '/https.json') return answerHttps(secure, response)
    if (path === '/here.json') return answerHere(request, response, here)
    if (path === '/botgarten.crt' && secure) return sendAuthority(secure, response)
    if (operator !== null && path === '/operator.md')
      return void response.setHeader('content-type', 'text/markdown; charset=utf-8').end(operator)
    handler(request, response, () => response.writeHead(404).end())
  }
  const server = createServer(listener)
  spreadConnections(server)
  server.listen({ port: options.port, host: options.host })
  await once(server, 'listening')
  const { port } = server.address() as AddressInfo
  try {
    if (options.https) secure = await startSecure(options.https, listener, nextPort(options), options.host)
  } catch (error) {
    await close(server)
    throw error
  }
  const securePort = secure?.port ?? null
  const reached = () => allAddresses(port, securePort, options.host)
  classServer?.reachedAt(reached)
  const url = `http://localhost:${port}`
  return { port, url, securePort, addresses: reached, close: () => closeAll(server, secure, classServer) }
}
