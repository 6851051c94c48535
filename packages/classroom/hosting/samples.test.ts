// Data folders that earlier versions wrote open in this one. scripts/samples/class-data.ts made them, at the commit that is
// the name of the folder.
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { openedIn } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { Server } from '../testing/world.ts'
import { accountsOn } from '../teaching/accounts.ts'
import { secretIn } from './data-folder.ts'
import { restore } from './restore.ts'

interface Known {
  readonly madeAt: number
  readonly class: string
  readonly code: string
  readonly pupils: readonly {
    /** Has shown the pictures in the lesson that is open. */
    readonly isBack: boolean
    readonly nickname: string
    readonly id: string
    readonly pictures: readonly string[]
    readonly cookies: Readonly<Record<string, string>>
  }[]
  readonly teacher: { readonly cookies: Readonly<Record<string, string>> }
}

const samples = join(import.meta.dirname, '..', 'samples')
const names = readdirSync(samples)
const knownOf = (name: string) => JSON.parse(readFileSync(join(samples, name, 'known.json'), 'utf8')) as Known

let folder: string
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten-sample-'))))
afterEach(() => {
  vi.useRealTimers()
  rmSync(folder, { recursive: true, force: true })
})

/** A server on the folder, a minute after the sample was made. */
async function serverOn({ madeAt }: Known) {
  const database = await openedIn(folder)
  const secret = secretIn(folder)
  // better-auth has a clock of its own, and the teacher's session lasts twelve hours.
  vi.useFakeTimers({ toFake: ['Date'], now: madeAt + 60_000 })
  const server = new Server(database, { secret, accounts: accountsOn(database, secret, Date.now) })
  server.now = madeAt + 60_000
  const browserWith = (cookies: Readonly<Record<string, string>>) => {
    const browser = server.browser()
    for (const [name, value] of Object.entries(cookies)) browser.cookies.set(name, value)
    return browser
  }
  return { server, database, browserWith }
}

test.each(names)(
  'the data folder of %s opens: pupils and teacher are signed in, and work continues',
  async (name) => {
    const known = knownOf(name)
    cpSync(join(samples, name), folder, { recursive: true })
    const { database, browserWith } = await serverOn(known)
    expect((await browserWith(known.teacher.cookies).get(`/classes/${known.class}`)).body).toMatchObject({
      ...{ name: '5b', code: known.code, pupils: 2, projects: 2 },
    })
    for (const { isBack, pictures, cookies } of known.pupils) {
      const browser = browserWith(cookies)
      expect((await browser.get('/projects')).status).toBe(isBack ? 200 : 401)
      if (!isBack) expect((await browser.post('/me/pictures', { pictures })).status).toBe(204)
      expect((await browser.get('/projects')).body).toMatchObject({
        projects: [{ id: 'project-friendship', revision: 2, name: 'Work 2' }],
        ...{ bin: [{ id: 'project-fear', revision: 1 }], mark: null, known: true },
      })
      // A page of that version, which is open still, sends no hash.
      expect(
        (await browser.put('/projects/project-friendship?base=2&save=save-after-update', projectText('3')))
          .body,
      ).toMatchObject({
        revision: 3,
      })
    }
    await database.close()
  },
)

test.each(names)('the backup of %s is restored where nothing is, with its key', async (name) => {
  const known = knownOf(name)
  const backups = join(samples, name, 'backups')
  const [file] = readdirSync(backups).filter((one) => !one.includes('answers'))
  cpSync(join(samples, name, 'secret.key'), join(folder, 'secret.key'))
  expect(await restore(folder, join(backups, file!), { day: '2026-11-28', phrase: null })).toMatchObject({
    ...{ kind: 'restored', before: null, deletionsUnknown: true },
  })
  const { server, database } = await serverOn(known)
  for (const { nickname, pictures } of known.pupils) {
    const browser = server.browser()
    expect((await browser.post('/return', { code: known.code, nickname, pictures })).status).toBe(200)
    expect((await browser.get('/projects/project-friendship')).body).toMatchObject({ revision: 2 })
  }
  await database.close()
})
