import { createServer, request, type IncomingMessage, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'

/** A proxy that gives each request to the next node; a node that is gone costs its requests a 502. */
export async function roundRobin(ports: readonly number[]) {
  let turn = 0
  function through(asking: IncomingMessage, answer: ServerResponse) {
    const port = ports[turn++ % ports.length]!
    const { method = 'GET', url = '/', headers } = asking
    const inside = request({ host: '127.0.0.1', port, method, path: url, headers }, (found) => {
      answer.writeHead(found.statusCode ?? 502, found.headers)
      found.pipe(answer)
    })
    inside.on('error', () => {
      if (!answer.headersSent) answer.writeHead(502)
      answer.end()
    })
    answer.on('close', () => inside.destroy())
    asking.pipe(inside)
  }
  const server = createServer(through)
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done))
  return {
    url: `http://localhost:${(server.address() as AddressInfo).port}`,
    close() {
      server.closeAllConnections()
      server.close()
    },
  }
}
