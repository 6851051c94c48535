import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { beforeAll, expect, test } from 'vitest'
import { migrate } from '../database/migrate.ts'
import { openSqlite } from '../database/sqlite.ts'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { projectText } from '../testing/projects.ts'
import { Server } from '../testing/world.ts'
import { carryOut } from './deleting-store.ts'

const tables = [
  'class',
  'pupil',
  'pupilSession',
  'project',
  'version',
  'answered',
  'asset',
  'versionAsset',
  'thrown',
  'mark',
] as const
const pixel = { type: 'image/png', base64: 'iVBORw0KGgo=' }

async function rowsAbout(server: Server, id: string): Promise<string[]> {
  const { db } = server.ports.database
  const found = []
  for (const table of tables)
    for (const row of await db
      .selectFrom(table as 'class')
      .selectAll()
      .execute())
      if (JSON.stringify(row).includes(id)) found.push(table)
  return found
}

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser

  beforeAll(async () => {
    server = new Server(await fresh())
    teacher = await server.firstTeacher()
  })

  const classWith = async (...nicknames: string[]) => {
    const opened = await server.openClass(teacher)
    const pupils = []
    for (const nickname of nicknames) {
      const pupil = await server.pupil(opened.code, nickname)
      const text = projectText(nickname, { ['b'.repeat(64)]: pixel })
      await pupil.browser.put('/projects/project-1?base=0&save=save-0001', text)
      await pupil.browser.put('/projects/project-2?base=0&save=save-0002', text)
      await pupil.browser.delete('/projects/project-2?base=1')
      pupils.push(pupil)
    }
    return { ...opened, pupils }
  }

  test('a class is deleted with all its data, once its name is typed; its devices are told it has ended', async () => {
    const [gone, stays] = [await classWith('Fuchs', 'Otter'), await classWith('Igel')]
    expect((await teacher.delete(`/classes/${gone.id}`, { name: '5c' })).status).toBe(400)
    expect(await rowsAbout(server, gone.id)).not.toEqual([])
    await teacher.delete(`/classes/${gone.id}`, { name: '5b' })
    expect(await rowsAbout(server, gone.id)).toEqual([])
    expect(server.buried.at(-1)).toEqual({ kind: 'class', id: gone.id })
    const visit = await gone.pupils[0]!.browser.get('/me')
    expect(visit).toMatchObject({ status: 410, body: { error: 'classEnded' } })
    expect((await stays.pupils[0]!.browser.get('/projects/project-1')).status).toBe(200)
  })

  test('one pupil is deleted with everything, and the others keep what they share', async () => {
    const { id, pupils } = await classWith('Hase', 'Wolf')
    const before = (await teacher.get(`/classes/${id}`)).body as { space: number }
    await teacher.delete(`/classes/${id}/pupils/${pupils[0]!.id}`)
    expect(await rowsAbout(server, pupils[0]!.id)).toEqual([])
    const read = await pupils[1]!.browser.get('/projects/project-1')
    expect(read.body).toMatchObject({ project: { assets: { ['b'.repeat(64)]: pixel } } })
    const after = (await teacher.get(`/classes/${id}`)).body as { space: number }
    expect(after.space).toBeLessThan(before.space)
    expect(after).toMatchObject({ pupils: 1, projects: 1, versions: 1 })
  })

  test('a deletion is carried out again after an older copy came back, as often as need be', async () => {
    const { id, pupils } = await classWith('Dachs', 'Biber')
    const { db } = server.ports.database
    for (let times = 0; times < 2; times++) {
      await db.transaction().execute((inside) => carryOut(inside, { kind: 'pupil', id: pupils[0]!.id }))
      await db.transaction().execute((inside) => carryOut(inside, { kind: 'class', id }))
      expect(await rowsAbout(server, id)).toEqual([])
    }
  })

  test('all about a pupil, for parents who ask', async () => {
    const { id, pupils } = await classWith('Luchs')
    const { body } = await teacher.get(`/classes/${id}/pupils/${pupils[0]!.id}/everything`)
    expect(JSON.parse(body as string)).toMatchObject({
      nickname: 'Luchs',
      projects: [{ id: 'project-1', project: { name: 'Garden Luchs' } }],
    })
  })

  test('a date that is moved is announced again', async () => {
    const { id } = await classWith('Uhu')
    await teacher.patch(`/classes/${id}`, { endsOn: server.ports.day(5) })
    expect((await teacher.get(`/classes/${id}`)).body).toMatchObject({ endsSoon: true })
    await teacher.patch(`/classes/${id}`, { endsOn: server.ports.day(60) })
    expect((await teacher.get(`/classes/${id}`)).body).toMatchObject({ endsSoon: false })
    expect((await teacher.patch(`/classes/${id}`, { endsOn: server.ports.day(0) })).status).toBe(400)
  })
})

test.each(['class', 'pupil'])('a deleted %s is in no file while the server runs on', async (kind) => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-deleted-'))
  const file = join(folder, 'class.db')
  const database = openSqlite(file)
  await migrate(database)
  const server = new Server(database)
  const teacher = await server.firstTeacher()
  const { id, code } = await server.openClass(teacher)
  const child = await server.pupil(code, 'Unverkennbar')
  await child.browser.put('/projects/project-1?base=0&save=save-0001', projectText('Unverwechselbar'))
  await teacher.post(`/classes/${id}/handouts`, { to: [child.id], kind: 'hint', text: 'Unvergessen.' })
  const found = () => {
    const bytes = readdirSync(folder).map((name) => readFileSync(join(folder, name), 'latin1'))
    return ['Unverkennbar', 'unverkennbar', 'Unverwechselbar', 'Unvergessen'].filter((name) =>
      bytes.some((one) => one.includes(name)),
    )
  }
  expect(found()).toHaveLength(4)
  if (kind === 'class') await teacher.delete(`/classes/${id}`, { name: '5b' })
  else await teacher.delete(`/classes/${id}/pupils/${child.id}`)
  expect(found()).toEqual([])
  await database.close()
  expect(found()).toEqual([])
  rmSync(folder, { recursive: true, force: true })
})
