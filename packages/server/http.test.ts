import { once } from 'node:events'
import { Agent, createServer, request, type IncomingMessage } from 'node:http'
import type { AddressInfo } from 'node:net'
import { text } from 'node:stream/consumers'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { readAway, requestOf } from './http.ts'

const server = createServer((incoming, response) => {
  // As for a request to the class, whose body is not read.
  requestOf(incoming)
  response.writeHead(429).end('refused')
  readAway(incoming)
})
const agent = new Agent({ keepAlive: true, maxSockets: 1 })

beforeAll(async () => {
  server.listen(0, '127.0.0.1')
  await once(server, 'listening')
})
afterAll(() => {
  agent.destroy()
  server.close()
})

async function send(bytes: number) {
  const { port } = server.address() as AddressInfo
  const sent = request({ port, agent, method: 'PUT', headers: { 'content-length': bytes } })
  sent.end(Buffer.alloc(bytes))
  const [answer] = (await once(sent, 'response')) as [IncomingMessage]
  return { status: answer.statusCode, body: await text(answer), port: sent.socket!.localPort }
}

test('the sender of a large body that was refused gets the answer, and the connection stays open for the next request', async () => {
  const first = await send(400_000)
  const second = await send(10)
  expect([first, second]).toMatchObject([
    { status: 429, body: 'refused' },
    { status: 429, body: 'refused' },
  ])
  expect(second.port).toBe(first.port)
})
