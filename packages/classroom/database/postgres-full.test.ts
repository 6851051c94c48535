// PostgreSQL whose disk is full: that of its tables, and that of its journal, without which it cannot run.
import { rmSync, statfsSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { sql } from 'kysely'
import { afterAll, afterEach, beforeAll, describe, expect, vi } from 'vitest'
import { noPostgres, startPostgres, type Postgres } from '../testing/postgres.ts'
import { projectText } from '../testing/projects.ts'
import { testOnDisk } from '../testing/small-disk.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { migrate } from './migrate.ts'
import { openPostgres } from './postgres.ts'

/** Fills a disk. @param left bytes that stay free @returns gives the room back */
function fill(disk: string, left = 0): () => void {
  const { bavail, bsize } = statfsSync(disk)
  const ballast = join(disk, 'ballast')
  writeFileSync(ballast, Buffer.alloc(bavail * bsize - left))
  return () => rmSync(ballast)
}

/** Letters that PostgreSQL can hardly compress, different for each number. */
const lettersFor = (seed: number) =>
  Array.from({ length: 400 }, (_, at) => ((seed + 1) * (at + 7) * 2_654_435_761).toString(36)).join('')

/** A class whose pupil saves. */
async function classAt(address: string) {
  const database = openPostgres(address)
  await migrate(database)
  const server = new Server(database, quickAccounts(database))
  const teacher = await server.firstTeacher()
  const { id, code } = await server.openClass(teacher)
  const { browser } = await server.pupil(code, 'Fuchs')
  const save = (base: number) =>
    browser.put(`/projects/project-1?base=${base}&save=save-on-${base}`, projectText(lettersFor(base)))
  return { database, server, teacher, id, browser, save }
}

describe.skipIf(noPostgres() !== null)('PostgreSQL without room', () => {
  let postgres: Postgres
  beforeAll(async () => {
    postgres = await startPostgres()
  })
  afterAll(() => postgres.stop())
  afterEach(() => vi.restoreAllMocks())

  testOnDisk(
    'a full disk of PostgreSQL refuses saves and deletions in words, work is read, and with room again both succeed',
    60,
    async (disk) => {
      const { database, teacher, id, browser, save } = await classAt(await postgres.newDatabase(disk))
      const makeRoom = fill(disk, 200_000)
      let revision = 0
      let refused: Awaited<ReturnType<typeof save>> | null = null
      while (!refused) {
        const answer = await save(revision)
        if (answer.status === 200) revision++
        else refused = answer
      }
      expect(refused).toMatchObject({ status: 507, body: { error: 'diskFull' } })
      expect((await browser.get('/projects/project-1')).body).toMatchObject({ revision })
      const remove = () => teacher.delete(`/classes/${id}`, { name: '5b' })
      expect(await remove()).toMatchObject({ status: 507, body: { error: 'diskFull' } })
      makeRoom()
      expect((await save(revision)).body).toMatchObject({ revision: revision + 1 })
      expect((await remove()).status).toBe(204)
      await database.close()
    },
  )

  testOnDisk(
    'a PostgreSQL that ended since its journal had no room is answered with 503, and the node works when it runs again',
    120,
    async (disk) => {
      const full = await startPostgres({ fsync: true, disk })
      const { database, server, browser, save } = await classAt(await full.newDatabase())
      expect((await save(0)).status).toBe(200)
      const makeRoom = fill(disk)
      const message = sql`select pg_logical_emit_message(true, 'test', repeat('x', 900000))`
      const untilFull = async () => {
        for (;;) await message.execute(database.db)
      }
      await expect(untilFull()).rejects.toThrow('No space left on device')
      const answers = [await save(1), await browser.get('/projects')]
      for (const { status, headers } of answers)
        expect([status, headers.get('retry-after')]).toEqual([503, '5'])
      // better-auth writes the error there.
      vi.spyOn(console, 'error').mockReturnValue()
      const signIn = { username: 'm.weber', password: 'kastanie im regen' }
      expect(await server.browser().post('/auth/sign-in/username', signIn)).toMatchObject({ status: 503 })
      makeRoom()
      await full.crash()
      await full.start()
      expect((await browser.get('/projects/project-1')).body).toMatchObject({ revision: 1 })
      expect((await save(1)).body).toMatchObject({ revision: 2 })
      await database.close()
      await full.stop()
    },
  )
})
