import type { IncomingMessage, ServerResponse } from 'node:http'
import { Readable } from 'node:stream'
import { pipeline } from 'node:stream/promises'
import type { ReadableStream } from 'node:stream/web'
import type { Caller } from '@botgarten/classroom'

const bodiless = new Set(['GET', 'HEAD'])

function headersOf({ headersDistinct }: IncomingMessage): Headers {
  const headers = new Headers()
  for (const [name, values = []] of Object.entries(headersDistinct))
    for (const value of values) headers.append(name, value)
  return headers
}

/** A request of Node as one of the platform. @throws TypeError for a method that none may have, such as TRACE */
export function requestOf(incoming: IncomingMessage): Request {
  const method = incoming.method ?? 'GET'
  const body = bodiless.has(method)
    ? {}
    : { body: Readable.toWeb(incoming) as unknown as globalThis.ReadableStream, duplex: 'half' as const }
  return new Request(`http://class.internal${incoming.url}`, {
    method,
    headers: headersOf(incoming),
    ...body,
  })
}

const plain = (address = '') => address.replace(/^::ffff:/, '')

/**
 * Who asks, as the socket has it. Only behind a proxy that is named do its headers count.
 * @param proxies addresses of proxies
 */
export function callerOf({ socket, headers }: IncomingMessage, proxies: readonly string[]): Caller {
  const address = plain(socket.remoteAddress)
  const reached = plain(socket.localAddress)
  if (!proxies.includes(address)) return { address, secure: 'encrypted' in socket, reached }
  // The last address is the one that the proxy itself has seen.
  const forwarded = String(headers['x-forwarded-for'] ?? '')
    .split(',')
    .at(-1)!
    .trim()
  const secure = headers['x-forwarded-proto'] === 'https'
  return { address: plain(forwarded) || address, secure, reached: null }
}

/** Bytes a ms of refused bodies, of all of them together. */
const speed = 4000
let refusedBodies = 0

/** Reads the rest of a body that was refused, so that the sender gets the answer; slowly, and without storing it. */
export function readAway(incoming: IncomingMessage): void {
  // The request's own reader would store it.
  incoming.removeAllListeners('data')
  refusedBodies++
  incoming.once('close', () => refusedBodies--)
  incoming.on('data', ({ length }: Buffer) => {
    incoming.pause()
    setTimeout(() => incoming.resume(), (length * refusedBodies) / speed).unref()
  })
  incoming.resume()
}

/** Sends an answer. JSON goes in one piece; all else, such as events that go on, as it comes. */
export async function send(answer: Response, response: ServerResponse): Promise<void> {
  for (const [name, value] of answer.headers) if (name !== 'set-cookie') response.setHeader(name, value)
  const cookies = answer.headers.getSetCookie()
  if (cookies.length > 0) response.setHeader('set-cookie', cookies)
  const isJson = answer.headers.get('content-type')?.startsWith('application/json') ?? false
  const json = isJson ? Buffer.from(await answer.arrayBuffer()) : null
  if (json) response.setHeader('content-length', json.length)
  response.writeHead(answer.status)
  if (json || !answer.body) return void response.end(json ?? undefined)
  // Whoever goes away ends the answer; that is no error of ours.
  // oxlint-disable-next-line typescript/no-unnecessary-type-assertion -- the compiler distinguishes the two streams
  await pipeline(Readable.fromWeb(answer.body as ReadableStream), response).catch(() => {})
}
