// Somebody has everything that the server has written, and knows when each pupil saved: which answers are whose?
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import SqliteFile from 'better-sqlite3'
import { sql } from 'kysely'
import { draw, stream } from '@botgarten/numbers'
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from 'vitest'
import type { Database } from '../database/database.ts'
import { migrate } from '../database/migrate.ts'
import { openPostgres } from '../database/postgres.ts'
import { openSqlite } from '../database/sqlite.ts'
import { keyedHash } from '../hashes.ts'
import { openedBackup } from '../testing/backups.ts'
import type { Browser } from '../testing/browser.ts'
import { noPostgres, startPostgres, type Postgres } from '../testing/postgres.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { permitOf } from './testing/devices.ts'
import { agreement, endLesson, playLesson, type Lesson } from './testing/lesson.ts'

const rounds = 5
const pupils = 30
const form = 'before'

/** Chance that is the same in every run: the test finds the same or nothing. */
function randomOf(seed: number) {
  const state = stream(seed, 'server')
  return (bytes: number) => Uint8Array.from({ length: bytes }, () => Math.floor(draw(state) * 256))
}

/** Chance of a lesson. */
function chanceOf(seed: number) {
  const state = stream(seed, 'lesson')
  return () => draw(state)
}

const serverOn = (database: Database) =>
  new Server(database, { ...quickAccounts(database), random: randomOf(5) })

/** Ids in the order in which they lie in bytes. */
const orderIn = (bytes: string, ids: readonly string[]) =>
  ids
    .map((id) => [id, bytes.indexOf(id)] as const)
    .filter(([, at]) => at >= 0)
    .toSorted(([, a], [, b]) => a - b)
    .map(([id]) => id)

const mean = (numbers: readonly number[]) => numbers.reduce((sum, one) => sum + one, 0) / numbers.length
/** Of 5 lessons of 30 an order that says nothing is this far from 0 once in a thousand. */
const nothingIsKnown = (agreements: readonly number[], of: string) => {
  expect(agreements, of).toHaveLength(rounds)
  expect(Math.abs(mean(agreements)), of).toBeLessThan(0.27)
}

/** Rows of codes are found by these. */
const ownersOf = ({ ports }: Server, { pupils, key }: Lesson) =>
  pupils.map(({ answer }) => keyedHash(ports.secret, 'answer of', key, answer))
const answersOf = ({ pupils }: Lesson) => pupils.map(({ answer }) => answer)

test('in the order of arrival an attacker would find out much, although answers come up to two minutes late', async () => {
  const database = openSqlite(':memory:')
  await migrate(database)
  const server = serverOn(database)
  const teacher = await server.firstTeacher()
  const lesson = await playLesson(server, teacher, form, { pupils, chance: chanceOf(1) })
  expect(agreement(answersOf(lesson), lesson.came)).toBeGreaterThan(0.8)
  await database.close()
})

describe('files of SQLite', () => {
  let folder: string
  let database: Database
  let server: Server
  let teacher: Browser
  beforeEach(async () => {
    folder = mkdtempSync(join(tmpdir(), 'botgarten-attack-'))
    database = openSqlite(join(folder, 'botgarten.db'))
    await migrate(database)
    server = serverOn(database)
    teacher = await server.firstTeacher()
  })
  afterEach(async () => {
    await database.close()
    rmSync(folder, { recursive: true, force: true })
  })
  const bytesOf = (name: string) => readFileSync(join(folder, name), 'latin1')
  const copiedAnswers = async () => (await openedBackup({ database, folder }))['answers.db']!

  test('no place and no order says whose an answer is, neither while it is open nor once it is closed', async () => {
    const found: Record<string, number[]> = {
      'file, open': [],
      'codes, open': [],
      'file, closed': [],
      backup: [],
      'rows, closed': [],
    }
    for (let seed = 0; seed < rounds; seed++) {
      const lesson = await playLesson(server, teacher, form, { pupils, chance: chanceOf(seed) })
      const ids = answersOf(lesson)
      const look = (name: string, order: readonly string[]) => found[name]!.push(agreement(ids, order))
      look('file, open', orderIn(bytesOf('answers.db'), ids))
      const owners = ownersOf(server, lesson)
      found['codes, open']!.push(agreement(owners, orderIn(bytesOf('answers.db'), owners)))
      await endLesson(server, teacher, lesson, form)
      look('file, closed', orderIn(bytesOf('answers.db'), ids))
      const rows = await database.answers.db
        .selectFrom('answer')
        .select('id')
        .where('asking', '=', lesson.key)
        .execute()
      look(
        'rows, closed',
        rows.map(({ id }) => id),
      )
      look('backup', orderIn(await copiedAnswers(), ids))
    }
    for (const [of, agreements] of Object.entries(found)) nothingIsKnown(agreements, of)
  }, 120_000)

  test('nothing of an answer is where pupils are, and nothing of a pupil where answers are', async () => {
    const lesson = await playLesson(server, teacher, form, { pupils: 6, chance: chanceOf(3) })
    await endLesson(server, teacher, lesson, form)
    const [{ code = '' } = {}] = await database.answers.db.selectFrom('answer').select('code').execute()
    const copy = await openedBackup({ database, folder })
    expect(Object.keys(copy)).toEqual([
      'answers.db',
      'botgarten.db',
      'deleted.jsonl',
      'manifest.json',
      'secret.key',
    ])
    expect(readdirSync(folder).filter((name) => name.includes('answers'))).toEqual(['answers.db'])
    const ofLab = [
      ...readdirSync(folder)
        .filter((name) => name.includes('botgarten'))
        .map(bytesOf),
      ...Object.entries(copy).map(([name, bytes]) => (name === 'answers.db' ? '' : bytes)),
    ].join('')
    for (const trace of [...answersOf(lesson), lesson.key, code!]) expect(ofLab).not.toContain(trace)
    const ofAnswers = bytesOf('answers.db') + copy['answers.db']!
    const sessions = await database.db.selectFrom('pupilSession').select('tokenHash').execute()
    const traces = [...lesson.pupils.flatMap(({ id, nickname }) => [id, nickname]), 'project-1', '192.168']
    for (const trace of [...traces, ...sessions.map(({ tokenHash }) => tokenHash)])
      expect(ofAnswers).not.toContain(trace)
  })

  test('no number of a row counts up, and no moment is kept but the day', async () => {
    const lesson = await playLesson(server, teacher, form, { pupils: 6, chance: chanceOf(3) })
    await endLesson(server, teacher, lesson, form)
    const file = new SqliteFile(join(folder, 'answers.db'), { readonly: true })
    for (const table of ['answer', 'code'])
      expect(() => file.prepare(`select rowid from ${table}`).all()).toThrow('no such column: rowid')
    const rows = ['asking', 'answer', 'published'].flatMap((table) =>
      file.prepare(`select * from ${table}`).all(),
    )
    file.close()
    expect(JSON.stringify(rows)).not.toMatch(/\d\d:\d\d|17\d{11}/)
    expect(JSON.stringify(rows).match(/2026-\d\d-\d\d/g)).toEqual(['2026-11-24'])
    const lab = new SqliteFile(join(folder, 'botgarten.db'), { readonly: true })
    expect(() => lab.prepare('select rowid from token').all()).toThrow('no such column: rowid')
    const columns = lab.prepare('select * from token').columns()
    lab.close()
    expect(columns.map(({ name }) => name)).toEqual(['pupil', 'form', 'blinded', 'again'])
  })

  test('two backups never differ by fewer than five people', async () => {
    const lesson = await playLesson(server, teacher, form, { pupils: 7, chance: chanceOf(3) })
    const at = `/classes/${lesson.class}/questionnaires`
    const copied = async (...more: readonly string[]) =>
      orderIn(await copiedAnswers(), [...answersOf(lesson), ...more]).length
    expect(await copied(...ownersOf(server, lesson))).toBe(0)
    await endLesson(server, teacher, lesson, form)
    expect(await copied()).toBe(7)
    await teacher.post(at, { form })
    const late = await permitOf((await server.pupil(lesson.code, 'Nachzügler')).browser)
    await server.browser().post('/answers', { ...late, code: null, values: {} })
    expect(await copied(late.id)).toBe(7)
    await endLesson(server, teacher, lesson, form)
    expect(await copied(late.id)).toBe(7)
  })

  test('the log holds no form, no id and no code, and does not tell two answers apart', async () => {
    const lesson = await playLesson(server, teacher, form, { pupils: 6, chance: chanceOf(3) })
    const lines = server.logged.filter(({ route }) => route.startsWith('/answers'))
    expect(lines.map((line) => JSON.stringify(line)).toSorted()).toEqual([
      ...Array<string>(6).fill('{"method":"POST","route":"/answers","status":204}'),
      ...Array<string>(6).fill('{"method":"POST","route":"/answers/code","status":200}'),
    ])
    for (const trace of [...answersOf(lesson), lesson.key, 'owl'])
      expect(JSON.stringify(server.logged)).not.toContain(trace)
  })
})

const why = noPostgres()
describe.skipIf(why !== null)(`a dump of PostgreSQL${why ? ` (skipped: ${why})` : ''}`, () => {
  let postgres: Postgres
  let database: Database
  let server: Server
  let teacher: Browser
  beforeAll(async () => {
    postgres = await startPostgres()
    database = openPostgres(await postgres.newDatabase())
    await migrate(database)
    server = serverOn(database)
    teacher = await server.firstTeacher()
  })
  afterAll(async () => {
    await database.close()
    await postgres.stop()
  })

  interface Row {
    readonly id: string
    readonly xmin: string
    readonly ctid: string
  }
  /** Rows in the order in which they lie. */
  const rowsOf = async ({ key }: Lesson) =>
    (
      await sql<Row>`select id, xmin::text, ctid::text from answer where asking = ${key} order by ctid`.execute(
        database.answers.db,
      )
    ).rows

  /** The file in which the answers lie. */
  async function heap(): Promise<string> {
    await sql`checkpoint`.execute(database.db)
    const { rows } = await sql<{ path: string }>`
      select current_setting('data_directory') || '/' || pg_relation_filepath('answers.answer') as path`.execute(
      database.db,
    )
    return readFileSync(rows[0]!.path, 'latin1')
  }

  test('no transaction, no place and no file says whose an answer is', async () => {
    const found: Record<string, number[]> = { 'places, open': [], 'places, closed': [], 'file, closed': [] }
    for (let seed = 0; seed < rounds; seed++) {
      const lesson = await playLesson(server, teacher, form, { pupils, chance: chanceOf(seed) })
      const ids = answersOf(lesson)
      const look = (name: string, order: readonly string[]) => found[name]!.push(agreement(ids, order))
      const open = await rowsOf(lesson)
      expect(new Set(open.map(({ xmin }) => xmin)).size).toBe(1)
      look(
        'places, open',
        open.map(({ id }) => id),
      )
      await endLesson(server, teacher, lesson, form)
      const closed = await rowsOf(lesson)
      expect(new Set(closed.map(({ xmin }) => xmin)).size).toBe(1)
      look(
        'places, closed',
        closed.map(({ id }) => id),
      )
      const bytes = await heap()
      // Nothing of what was there before: each answer lies there once.
      for (const id of ids) expect(bytes.split(id)).toHaveLength(2)
      look('file, closed', orderIn(bytes, ids))
    }
    for (const [of, agreements] of Object.entries(found)) nothingIsKnown(agreements, of)
  }, 120_000)

  test('answers have a schema and a role of their own, which a query of the lab is not', async () => {
    const { rows } = await sql<{ owner: string }>`
      select tableowner as owner from pg_tables where schemaname = 'answers' and tablename = 'answer'`.execute(
      database.db,
    )
    expect(rows).toEqual([{ owner: 'botgarten_answers' }])
    const { rows: may } = await sql<{ may: boolean }>`
      select has_schema_privilege('public', 'answers', 'usage') as may`.execute(database.db)
    expect(may).toEqual([{ may: false }])
  })
})
