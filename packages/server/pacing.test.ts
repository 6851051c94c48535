import { EventEmitter, once } from 'node:events'
import { createServer } from 'node:http'
import { connect, type AddressInfo, type Server, type Socket } from 'node:net'
import { setImmediate as nextTurn } from 'node:timers/promises'
import { expect, test } from 'vitest'
import { spreadConnections } from './pacing.ts'

/** A socket that records whether it is read. */
const socket = () => {
  const one = { isRead: true, pause: () => (one.isRead = false), resume: () => (one.isRead = true) }
  return one
}

test('of a burst of connections only four more are read in each turn, in their order', async () => {
  const server = new EventEmitter() as Server
  spreadConnections(server)
  const sockets = Array.from({ length: 10 }, socket)
  for (const one of sockets) server.emit('connection', one as unknown as Socket)
  const read: number[] = []
  for (let turn = 0; turn < 4; turn++) {
    read.push(sockets.findIndex(({ isRead }) => !isRead))
    await nextTurn()
  }
  expect(read).toEqual([0, 4, 8, -1])
  expect(sockets.every(({ isRead }) => isRead)).toBe(true)
})

test('a connection after a burst is read in the next turn', async () => {
  const server = new EventEmitter() as Server
  spreadConnections(server)
  for (let at = 0; at < 9; at++) server.emit('connection', socket() as unknown as Socket)
  for (let turn = 0; turn < 3; turn++) await nextTurn()
  const later = socket()
  server.emit('connection', later as unknown as Socket)
  expect(later.isRead).toBe(false)
  await nextTurn()
  expect(later.isRead).toBe(true)
})

test('every request of a burst of 300 real connections is answered, and connections that ended hold up no other', async () => {
  const server = createServer((_, response) => void response.end('here'))
  spreadConnections(server)
  server.listen(0, '127.0.0.1')
  await once(server, 'listening')
  const { port } = server.address() as AddressInfo
  const gone = Array.from({ length: 50 }, () => connect(port, '127.0.0.1'))
  for (const one of gone) one.once('connect', () => one.destroy())
  const answers = Array.from({ length: 300 }, async () => (await fetch(`http://127.0.0.1:${port}/`)).text())
  expect(new Set(await Promise.all(answers))).toEqual(new Set(['here']))
  server.closeAllConnections()
  server.close()
  await once(server, 'close')
})
