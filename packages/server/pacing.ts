import type { Server, Socket } from 'node:net'

/** New connections that are read in one turn of the event loop. */
const perTurn = 4

/**
 * Spreads a burst of new connections over turns of the event loop, so that requests on open connections are answered in
 * between: 1,000 at once would keep them waiting until all are read.
 */
export function spreadConnections(server: Server): void {
  const waiting: Socket[] = []
  const readSome = () => {
    for (const socket of waiting.splice(0, perTurn)) socket.resume()
    if (waiting.length > 0) setImmediate(readSome)
  }
  server.on('connection', (socket) => {
    socket.pause()
    if (waiting.push(socket) === 1) setImmediate(readSome)
  })
}
