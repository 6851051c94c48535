import { sql } from 'kysely'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { noPostgres, startPostgres, type Postgres } from '../testing/postgres.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { migrate } from './migrate.ts'
import { openPostgres } from './postgres.ts'
import type { Database } from './database.ts'

describe.skipIf(noPostgres() !== null)('PostgreSQL that crashes or freezes', () => {
  let postgres: Postgres
  let database: Database
  let server: Server
  let code: string

  beforeAll(async () => {
    postgres = await startPostgres()
    database = openPostgres(await postgres.newDatabase())
    await migrate(database)
    server = new Server(database, quickAccounts(database))
    ;({ code } = await server.openClass(await server.firstTeacher()))
  })
  afterAll(async () => {
    await database.close()
    await postgres.stop()
  })

  test.each([
    ['the lab', () => database.db],
    ['the answers', () => database.answers.db],
  ])(
    'a crash between two queries of a transaction of %s rejects it, and the next one works',
    async (_of, db) => {
      const working = db() as Database['db']
      const transaction = working.transaction().execute(async (inside) => {
        await sql`select 1`.execute(inside)
        await postgres.crash()
        // The connection reports its error in a turn of its own.
        await new Promise((resolve) => setTimeout(resolve, 100))
        await sql`select 1`.execute(inside)
      })
      await expect(transaction).rejects.toThrow()
      await postgres.start()
      expect(await sql<{ one: number }>`select 1 as one`.execute(working)).toMatchObject({
        rows: [{ one: 1 }],
      })
    },
  )

  test(
    'pupils who save during a crash get 503 or their save, and no acknowledged save is lost',
    { timeout: 60_000 },
    async () => {
      const pupils = await Promise.all(Array.from({ length: 6 }, (_, at) => server.pupil(code, `Kind ${at}`)))
      const acknowledged = pupils.map(() => 0)
      const statuses = new Set<number>()
      let running = true
      let isUp = Promise.resolve()
      const saving = pupils.map(async ({ browser }, at) => {
        while (running) {
          const base = acknowledged[at]!
          const path = `/projects/project-1?base=${base}&save=save-${at}-on-${base}`
          const { status, body } = await browser.put(path, projectText(`${at} ${base}`))
          statuses.add(status)
          if (status === 200) acknowledged[at] = (body as { revision: number }).revision
          else await isUp
        }
      })
      const allSave = async () => {
        const before = [...acknowledged]
        const all = () => acknowledged.every((revision, at) => revision > before[at]!)
        await expect.poll(all, { timeout: 30_000 }).toBe(true)
      }
      await allSave()
      isUp = postgres.crash().then(() => postgres.start())
      await isUp
      await allSave()
      running = false
      await Promise.all(saving)
      expect([...statuses].toSorted()).toEqual([200, 503])
      const rows = await database.db.selectFrom('project').select('revision').execute()
      const has = rows.map(({ revision }) => revision).toSorted((one, other) => one - other)
      expect(has).toEqual(acknowledged.toSorted((one, other) => one - other))
    },
  )

  test('a database that is frozen is answered with 503 and a time to try again, and goes on after it', async () => {
    const address = await postgres.newDatabase()
    const patient = openPostgres(address, { connecting: 300, statement: 300, reply: 300 })
    await migrate(patient)
    const asked = new Server(patient, quickAccounts(patient))
    const { browser } = await asked.pupil((await asked.openClass(await asked.firstTeacher())).code, 'Fuchs')
    postgres.freeze()
    const answers = await Promise.all(Array.from({ length: 16 }, () => browser.get('/projects')))
    postgres.thaw()
    expect(answers.map(({ status }) => status)).toEqual(Array(16).fill(503))
    expect(answers[0]!.headers.get('retry-after')).toBe('5')
    await expect.poll(async () => (await browser.get('/projects')).status, { timeout: 20_000 }).toBe(200)
    await patient.close()
  })
})
