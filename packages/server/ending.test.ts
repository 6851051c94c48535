import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { once } from 'node:events'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { openClassServer, type ClassServer } from './class-server.ts'
import { dayHere } from './ports.ts'
import { Client } from './rehearsal/client.ts'

let data: string
beforeEach(() => void (data = mkdtempSync(join(tmpdir(), 'botgarten-ending-'))))
afterEach(() => rmSync(data, { recursive: true, force: true }))

interface Running {
  readonly classServer: ClassServer
  readonly url: string
  readonly close: () => Promise<void>
}

async function start(): Promise<Running> {
  const classServer = await openClassServer({ data })
  const server = createServer((request, response) => void classServer.answer(request, response))
  server.listen(0, '127.0.0.1')
  await once(server, 'listening')
  const { port } = server.address() as AddressInfo
  async function close() {
    server.closeAllConnections()
    server.close()
    await classServer.close()
  }
  return { classServer, url: `http://127.0.0.1:${port}`, close }
}

const signIn = { username: 'm.weber', password: 'kastanie im regen' }

async function signedIn(url: string): Promise<Client> {
  const teacher = new Client(url)
  await teacher.untilDone('POST', '/auth/sign-in/username', signIn)
  return teacher
}

/** A server with a class that ended yesterday, which last ran some days ago. @returns the id of the class */
async function endedYesterday(daysAgo: number): Promise<string> {
  const { classServer, url, close } = await start()
  const teacher = new Client(url)
  await teacher.untilDone('POST', '/teachers', { token: await classServer.firstTeacher(), ...signIn })
  const about = { name: '5b', language: 'en', grade: 5, endsOn: '2099-01-31' }
  const { id } = await teacher.untilDone<{ id: string }>('POST', '/classes', about)
  const { db } = classServer.ports.database
  await db
    .updateTable('class')
    .set({ endsOn: dayHere(-1) })
    .execute()
  const value = JSON.stringify({ last: dayHere(-daysAgo), doubt: null })
  await db.updateTable('meta').set({ value }).where('key', '=', 'running days').execute()
  await close()
  return id
}

const buried = () => {
  const file = join(data, 'deleted.jsonl')
  return existsSync(file) ? readFileSync(file, 'utf8') : ''
}

test('a class that has ended is deleted before the first answer of the next start', async () => {
  const id = await endedYesterday(7)
  expect(buried()).toBe('')
  const { classServer, url, close } = await start()
  const rows = await classServer.ports.database.db.selectFrom('class').select('id').execute()
  expect(rows).toEqual([])
  expect((await (await signedIn(url)).ask('GET', `/classes/${id}`)).status).toBe(404)
  expect(buried()).toContain(id)
  await close()
})

test('after more than a week without running it is hidden from the first answer on, until the operator confirms the clock', async () => {
  const id = await endedYesterday(8)
  const { url, close } = await start()
  const teacher = await signedIn(url)
  expect((await teacher.ask('GET', `/classes/${id}`)).status).toBe(423)
  expect(buried()).toBe('')
  await teacher.untilDone('POST', '/clock', { right: true, today: dayHere(0) })
  expect((await teacher.ask('GET', `/classes/${id}`)).status).toBe(404)
  expect(buried()).toContain(id)
  await close()
})
