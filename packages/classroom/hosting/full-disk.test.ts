// A teacher deletes on a disk where nothing else fits.
import { existsSync, readdirSync, readFileSync, statfsSync, statSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { afterEach, expect, test, vi } from 'vitest'
import { migrate } from '../database/migrate.ts'
import { openSqlite } from '../database/sqlite.ts'
import { everyNight } from '../teaching/every-night.ts'
import { addTombstone } from '../teaching/deleting-store.ts'
import { onBothDatabases } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { testOnDisk } from '../testing/small-disk.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { fillReserve, useReserve } from './reserve.ts'
import { bury, buriedIn } from './tombstones.ts'

afterEach(() => vi.restoreAllMocks())

const megabyte = 1_000_000
const reserve = 8 * megabyte

const freeOn = (disk: string) => {
  const { bavail, bsize } = statfsSync(disk)
  return bavail * bsize
}

/** Fills a disk to its last byte. */
function fill(disk: string) {
  for (let count = 0; freeOn(disk) > 0; count++)
    try {
      writeFileSync(join(disk, `ballast-${count}`), Buffer.alloc(freeOn(disk)))
    } catch {
      // As much as fits stays.
    }
}

/** A class with a pupil on a disk; `work` of the pupil is as large as asked for. */
async function classOn(disk: string, megabytes: number) {
  const database = openSqlite(join(disk, 'class.db'))
  await migrate(database)
  const server = new Server(database, {
    ...quickAccounts(database),
    bury: (tombstone) => Promise.resolve(bury(disk, tombstone)),
  })
  Object.assign(server.ports.host, {
    freeSpace: () => freeOn(disk),
    useReserve: (bytes?: number) => useReserve(disk, bytes),
  })
  const teacher = await server.firstTeacher()
  const opened = await server.openClass(teacher)
  const child = await server.pupil(opened.code, 'Unverkennbar')
  await child.browser.put('/projects/project-1?base=0&save=save-0001', projectText('Unverwechselbar'))
  const of = { pupil: child.id, class: opened.id }
  const document = 'x'.repeat(megabyte / 2)
  for (let revision = 100; revision < megabytes + 100; revision++) {
    const version = { ...of, project: 'project-1', revision, savedAt: 0, bytes: 1, hash: '', document }
    await database.db.insertInto('version').values(version).execute()
    const asset = { class: opened.id, hash: `hash-${revision}`, type: 'image/png', base64: document }
    await database.db.insertInto('asset').values(asset).execute()
  }
  return { database, server, teacher, child, id: opened.id }
}

const wordsIn = (disk: string) => {
  const names = readdirSync(disk).filter((name) => !name.startsWith('ballast'))
  const files = names.map((name) => readFileSync(join(disk, name), 'latin1'))
  return ['Unverkennbar', 'Unverwechselbar', 'x'.repeat(100)].filter((word) =>
    files.some((file) => file.includes(word)),
  )
}

for (const kind of ['class', 'pupil'] as const)
  testOnDisk(
    `on a full disk a teacher signs in and deletes a ${kind} that is larger than the reserve, and it is in no file`,
    60,
    async (disk) => {
      const { database, server, child, id } = await classOn(disk, 16)
      // Its teacher is shown that the end is near, which is noted.
      const endsOn = server.ports.day(5)
      await database.db.updateTable('class').set({ endsOn }).where('id', '=', id).execute()
      await fillReserve(disk, reserve)
      database.emptyJournal()
      fill(disk)
      const save = await child.browser.put('/projects/project-1?base=1&save=save-0002', projectText('2'))
      expect(save).toMatchObject({ status: 507, body: { error: 'diskFull' } })
      expect(wordsIn(disk)).toHaveLength(3)
      // better-auth writes the error of the first attempt there.
      vi.spyOn(console, 'error').mockReturnValue()
      const teacher = server.browser()
      const password = { username: 'm.weber', password: 'kastanie im regen' }
      expect((await teacher.post('/auth/sign-in/username', password)).status).toBe(204)
      for (const page of ['/classes', `/classes/${id}`, `/classes/${id}/data`]) {
        fill(disk)
        expect((await teacher.get(page)).status).toBe(200)
      }
      fill(disk)
      const path = kind === 'class' ? `/classes/${id}` : `/classes/${id}/pupils/${child.id}`
      expect((await teacher.delete(path, kind === 'class' ? { name: '5b' } : undefined)).status).toBe(204)
      expect(buriedIn(disk)).toEqual([{ kind, id: kind === 'class' ? id : child.id }])
      expect(wordsIn(disk)).toEqual([])
      const rows = await database.db.selectFrom('pupil').selectAll().execute()
      expect(rows).toEqual([])
      await database.close()
    },
  )

testOnDisk('on a full disk a class is deleted at night after its last day', 60, async (disk) => {
  const { database, server, id } = await classOn(disk, 16)
  const ended = { endsOn: server.ports.day(-1), announcedDay: -100 }
  await database.db.updateTable('class').set(ended).where('id', '=', id).execute()
  await fillReserve(disk, reserve)
  database.emptyJournal()
  fill(disk)
  await everyNight(server.ports)
  expect(buriedIn(disk)).toEqual([{ kind: 'class', id }])
  expect(wordsIn(disk)).toEqual([])
  await database.close()
})

testOnDisk(
  'without its reserve a full disk refuses deletion and sign-in with a sentence',
  30,
  async (disk) => {
    const { database, server, teacher, id } = await classOn(disk, 4)
    database.emptyJournal()
    fill(disk)
    const answer = await teacher.delete(`/classes/${id}`, { name: '5b' })
    expect(answer).toMatchObject({ status: 507, body: { error: 'diskFull' } })
    expect((await teacher.get(`/classes/${id}`)).status).toBe(200)
    vi.spyOn(console, 'error').mockReturnValue()
    const password = { username: 'm.weber', password: 'kastanie im regen' }
    const signIn = await server.browser().post('/auth/sign-in/username', password)
    expect(signIn).toMatchObject({ status: 507, body: { error: 'diskFull' } })
    await database.close()
  },
)

testOnDisk(
  'the reserve is made where as much again stays free, and filled up after use',
  20,
  async (disk) => {
    const size = () => (existsSync(join(disk, 'reserve')) ? statSync(join(disk, 'reserve')).size : 0)
    await fillReserve(disk, 11 * megabyte)
    expect(size()).toBe(0)
    await fillReserve(disk, 2_500_000)
    expect(size()).toBe(2_500_000)
    useReserve(disk, megabyte)
    expect(size()).toBe(1_500_000)
    await fillReserve(disk, 2_500_000)
    expect(size()).toBe(2_500_000)
    useReserve(disk)
    expect(size()).toBe(0)
  },
)

onBothDatabases((fresh) => {
  test('a deletion in steps that was interrupted is finished in the next night', async () => {
    const server = new Server(await fresh())
    const teacher = await server.firstTeacher()
    const { id, code } = await server.openClass(teacher)
    const other = await server.openClass(teacher)
    const [gone, stays] = [await server.pupil(other.code, 'Hase'), await server.pupil(other.code, 'Wolf')]
    await server.pupil(code, 'Fuchs')
    const { db } = server.ports.database
    await addTombstone(db, { kind: 'class', id })
    await addTombstone(db, { kind: 'pupil', id: gone.id })
    await everyNight(server.ports)
    expect(await db.selectFrom('class').select('id').execute()).toEqual([{ id: other.id }])
    expect(await db.selectFrom('pupil').select('id').execute()).toEqual([{ id: stays.id }])
  })
})
