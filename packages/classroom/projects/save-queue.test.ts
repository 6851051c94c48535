import { mkdtempSync, rmSync, statSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import type { Database } from '../database/database.ts'
import { migrate } from '../database/migrate.ts'
import { openSqlite } from '../database/sqlite.ts'
import { Limits } from '../limits.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { saveQueueOn } from './save-queue.ts'

let folder: string
let database: Database
beforeEach(async () => {
  folder = mkdtempSync(join(tmpdir(), 'botgarten-queue-'))
  database = openSqlite(join(folder, 'class.db'))
  await migrate(database)
})
afterEach(async () => {
  await database.close()
  rmSync(folder, { recursive: true, force: true })
})

/** The database with its transactions counted: each waits for the disk once. */
function counted() {
  let commits = 0
  const db = new Proxy(database.db, {
    get(target, name) {
      if (name === 'transaction') commits++
      const value: unknown = Reflect.get(target, name)
      return typeof value === 'function' ? (value.bind(target) as unknown) : value
    },
  })
  return { save: saveQueueOn({ ...database, db }), commits: () => commits }
}

/** For a pupil who saves as fast as one can: each request finds its bucket full. */
function unlimited() {
  let elapsed = 0
  return new Limits(() => (elapsed += 60_000))
}

async function classWith(children: number, changes: Partial<Server['ports']>) {
  const server = new Server(database, { ...quickAccounts(database), ...changes })
  const { code } = await server.openClass(await server.firstTeacher())
  const pupils = []
  for (let at = 0; at < children; at++) pupils.push((await server.pupil(code, `Kind ${at}`)).browser)
  return pupils
}

const text = (at: number) => projectText(`${at} ${'x'.repeat(15_000)}`)

test('saves that come while others are committed wait for the next commit alone, all of them in one', async () => {
  const { save, commits } = counted()
  const pupils = await classWith(20, { save })
  const answers = await Promise.all(
    pupils.map((pupil, at) => pupil.put('/projects/project-1?base=0&save=save-0001', text(at))),
  )
  expect(answers.map(({ status }) => status)).toEqual(Array(20).fill(200))
  // The first ones, and those that came meanwhile: with 30 ms for the disk nobody waits for more than two of them.
  expect(commits()).toBeLessThanOrEqual(4)
})

test('with 30 ms more for each wait for the disk no save of a class of 35 waits for 200 ms of them', async () => {
  const { save: kept, commits } = counted()
  const pupils = await classWith(35, { save: kept })
  const waited: number[] = []
  async function save(pupil: (typeof pupils)[number], at: number) {
    const began = commits()
    const { status } = await pupil.put(`/projects/project-1?base=${at}&save=save-${1000 + at}`, text(at))
    expect(status).toBe(200)
    waited.push(30 * (commits() - began))
  }
  for (let at = 0; at < 8; at++) await Promise.all(pupils.map((pupil) => save(pupil, at)))
  // The journal may have been on its way into the file when a save came.
  expect(Math.max(...waited) + 2 * 30).toBeLessThan(200)
})

test('the journal of the file does not grow without end, also where one save follows the other', async () => {
  const [pupil] = await classWith(1, { limits: unlimited() })
  for (let at = 0; at < 400; at++)
    await pupil!.put(`/projects/project-1?base=${at}&save=save-${1000 + at}`, text(at))
  expect(statSync(join(folder, 'class.db-wal')).size).toBeLessThan(20_000_000)
  expect((await pupil!.get('/projects/project-1')).body).toMatchObject({ revision: 400 })
})

test('between saves the journal is put away, before a commit has to do it', async () => {
  let times = 0
  const checkpoint = () => (times++, database.checkpoint!())
  const [pupil] = await classWith(1, {
    limits: unlimited(),
    save: saveQueueOn({ ...database, checkpoint }),
  })
  for (let at = 0; at < 300; at++) {
    await pupil!.put(`/projects/project-1?base=${at}&save=save-${1000 + at}`, text(at))
    await new Promise(setImmediate)
  }
  expect(times).toBeGreaterThan(1)
  expect(statSync(join(folder, 'class.db-wal')).size).toBeLessThan(12_000_000)
})

test('a disk that is too full to put the journal away breaks no save', async () => {
  const checkpoint = () => {
    throw Object.assign(new Error(''), { code: 'SQLITE_FULL' })
  }
  const [pupil] = await classWith(1, {
    limits: unlimited(),
    save: saveQueueOn({ ...database, checkpoint }),
  })
  for (let at = 0; at < 150; at++) {
    const answer = await pupil!.put(`/projects/project-1?base=${at}&save=save-${1000 + at}`, text(at))
    expect(answer.status).toBe(200)
    await new Promise(setImmediate)
  }
})
