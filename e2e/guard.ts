import { once } from 'node:events'
import { createServer, request, type IncomingMessage, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'

/** Stands before a server: counts what goes through, may answer in its place, and can shut the door. */
export interface Guard {
  readonly port: number
  /** Addresses that were asked for, and how many bytes of answers went through. */
  readonly asked: readonly string[]
  readonly bytes: number
  /** From now on what is read at an address is changed on its way. */
  change(path: string, how: (text: string) => string): void
  /** The cable is pulled: nobody gets through. */
  shut(): Promise<void>
  /** The cable is back, at the same address. */
  open(): Promise<void>
}

export async function guardOf(server: string): Promise<Guard> {
  const changes = new Map<string, (text: string) => string>()
  const asked: string[] = []
  let bytes = 0

  function through(asking: IncomingMessage, answer: ServerResponse) {
    const path = asking.url ?? '/'
    asked.push(path)
    const how = changes.get(path)
    const headers = { ...asking.headers, ...(how ? { 'accept-encoding': 'identity' } : {}) }
    const inside = request(`${server}${path}`, { method: asking.method ?? 'GET', headers }, (found) => {
      if (how) return void changed(found, answer, how)
      answer.writeHead(found.statusCode ?? 500, found.headers)
      found.on('data', (part: Buffer) => (bytes += part.length)).pipe(answer)
    })
    inside.on('error', () => answer.destroy())
    asking.pipe(inside)
  }

  let house = createServer(through)
  const listen = async (port: number) => {
    house.listen(port, '127.0.0.1')
    await once(house, 'listening')
  }
  await listen(0)
  const { port } = house.address() as AddressInfo
  return {
    port,
    asked,
    get bytes() {
      return bytes
    },
    change: (path, how) => changes.set(path, how),
    async shut() {
      if (!house.listening) return
      const closed = once(house, 'close')
      house.close()
      house.closeAllConnections()
      await closed
    },
    async open() {
      house = createServer(through)
      await listen(port)
    },
  }
}

async function changed(found: IncomingMessage, answer: ServerResponse, how: (text: string) => string) {
  let text = ''
  for await (const part of found.setEncoding('utf8')) text += String(part)
  const { 'content-length': _length, etag: _etag, ...headers } = found.headers
  answer.writeHead(found.statusCode ?? 500, headers).end(how(text))
}
