// A class server in a process of its own, asked by messages, that a test kills: `node child-process.ts <address>`.
import type { Database } from '../database/database.ts'
import { migrate } from '../database/migrate.ts'
import { openPostgres } from '../database/postgres.ts'
import { openSqlite } from '../database/sqlite.ts'
import { Server } from './world.ts'

export interface Question {
  readonly id: number
  readonly method: string
  readonly path: string
  readonly headers: Record<string, string>
  readonly body: string | null
}

export interface Reply {
  readonly id: number
  readonly status: number
  readonly text: string
}

/** @param address of PostgreSQL, or the path of a file */
export const open = (address: string): Database =>
  address.startsWith('postgres:') ? openPostgres(address) : openSqlite(address)

async function main(address: string) {
  const database = open(address)
  await migrate(database)
  const server = new Server(database)
  process.on('message', ({ id, method, path, headers, body }: Question) => {
    const request = new Request(`http://lab.test/api/class${path}`, { method, headers, body })
    void server.ask(request).then(async (answer) => {
      process.send!({ id, status: answer.status, text: await answer.text() } satisfies Reply)
    })
  })
  process.send!('ready')
}

if (import.meta.main) await main(process.argv[2]!)
