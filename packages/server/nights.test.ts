import { existsSync, mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { lastBackup, nightliesIn, openDataFolder, otherCopiesIn, secretIn } from '@botgarten/classroom'
import { quickAccounts, Server } from '@botgarten/classroom/testing'
import { expect, test } from 'vitest'
import { startNights } from './nights.ts'

const aWeek = 7 * 24 * 60

test('each start makes the backup of today, deletes copies that are a week old, and makes the reserve for deletions', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-nights-'))
  const opened = await openDataFolder(folder, { secret: secretIn(folder), day: '2026-11-24' })
  if (opened.kind === 'broken') throw new Error('The database is broken.')
  const server = new Server(opened.database)
  const start = async () => (await startNights(server.ports, folder))()
  writeFileSync(join(folder, 'botgarten.db.before-restore-1'), 'an earlier database')
  await start()
  expect(nightliesIn(folder)).toEqual([])
  expect(existsSync(join(folder, 'reserve'))).toBe(false)
  await server.firstTeacher()
  await start()
  expect(lastBackup(folder)).toMatchObject({ day: '2026-11-24', number: 1 })
  expect(statSync(join(folder, 'reserve')).size).toBe(24_000_000)
  server.later(aWeek - 24 * 60)
  await start()
  expect(otherCopiesIn(folder).byAge).toEqual(['botgarten.db.before-restore-1'])
  server.later(24 * 60)
  await start()
  expect(otherCopiesIn(folder).byAge).toEqual([])
  expect(nightliesIn(folder).map(({ day }) => day)).toEqual(['2026-11-30', '2026-12-01'])
  await opened.database.close()
  rmSync(folder, { recursive: true })
})

test('while the clock is doubted no copy is deleted; once the operator has confirmed it, copies go by their age', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-nights-'))
  const opened = await openDataFolder(folder, { secret: secretIn(folder), day: '2026-11-24' })
  if (opened.kind === 'broken') throw new Error('The database is broken.')
  const server = new Server(opened.database, quickAccounts(opened.database))
  const start = async () => (await startNights(server.ports, folder))()
  writeFileSync(join(folder, 'botgarten.db.before-restore-1'), 'an earlier database')
  const teacher = await server.firstTeacher()
  await start()
  server.later(2 * aWeek)
  await start()
  expect(otherCopiesIn(folder).byAge).toEqual(['botgarten.db.before-restore-1'])
  const answer = { right: true, today: server.ports.day(0) }
  await teacher.post('/auth/sign-in/username', { username: 'm.weber', password: 'kastanie im regen' })
  expect((await teacher.post('/clock', answer)).status).toBe(204)
  await start()
  expect(otherCopiesIn(folder).byAge).toEqual([])
  await opened.database.close()
  rmSync(folder, { recursive: true })
})
