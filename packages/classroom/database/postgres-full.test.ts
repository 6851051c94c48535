// PostgreSQL whose disk is full: that of its tables, and that of its journal, without which it cannot run.
import { rmSync, statfsSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { sql } from 'kysely'
import { afterAll, afterEach, beforeAll, describe, expect, vi } from 'vitest'
import { everyNight } from '../teaching/every-night.ts'
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
  const { browser, id: pupil } = await server.pupil(code, 'Fuchs')
  const saving = (child: typeof browser) => (base: number) =>
    child.put(`/projects/project-1?base=${base}&save=save-on-${base}`, projectText(lettersFor(base)))
  return { database, server, teacher, id, code, browser, pupil, saving, save: saving(browser) }
}

type Class = Awaited<ReturnType<typeof classAt>>

/** @returns the last revision that was acknowledged, and the answer after it */
async function saveUntilRefused(save: Class['save']) {
  for (let revision = 0; ; revision++) {
    const answer = await save(revision)
    if (answer.status !== 200) return { revision, refused: answer }
  }
}

describe.skipIf(noPostgres() !== null)('PostgreSQL without room', () => {
  let postgres: Postgres
  beforeAll(async () => {
    postgres = await startPostgres()
  })
  afterAll(() => postgres.stop())
  afterEach(() => vi.restoreAllMocks())

  testOnDisk(
    'a full disk of PostgreSQL refuses saves in words, and with room again they go on',
    60,
    async (disk) => {
      const { database, browser, save } = await classAt(await postgres.newDatabase(disk))
      const makeRoom = fill(disk, 200_000)
      const { revision, refused } = await saveUntilRefused(save)
      expect(refused).toMatchObject({ status: 507, body: { error: 'diskFull' } })
      expect((await browser.get('/projects/project-1')).body).toMatchObject({ revision })
      makeRoom()
      expect((await save(revision)).body).toMatchObject({ revision: revision + 1 })
      await database.close()
    },
  )

  for (const kind of ['class', 'pupil'] as const)
    testOnDisk(`on a full disk of PostgreSQL a teacher deletes a ${kind}`, 60, async (disk) => {
      const { database, server, teacher, id, code, browser, pupil, saving } = await classAt(
        await postgres.newDatabase(disk),
      )
      const other = await server.pupil(code, 'Otter')
      expect((await saving(browser)(0)).status).toBe(200)
      await everyNight(server.ports)
      fill(disk, 200_000)
      // The other pupil's rows come last, so that the tables stay as long as they are.
      await saveUntilRefused(saving(other.browser))
      const path = kind === 'class' ? `/classes/${id}` : `/classes/${id}/pupils/${pupil}`
      expect((await teacher.delete(path, kind === 'class' ? { name: '5b' } : undefined)).status).toBe(204)
      const left = await database.db.selectFrom('version').select('pupil').distinct().execute()
      expect(left).toEqual(kind === 'class' ? [] : [{ pupil: other.id }])
      expect((await browser.get('/projects')).status).toBe(kind === 'class' ? 410 : 401)
      const tombstones = await database.db.selectFrom('tombstone').select('id').execute()
      expect(tombstones).toEqual([{ id: kind === 'class' ? id : pupil }])
      await database.close()
    })

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
