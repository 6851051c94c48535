import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { openClassServer } from '@botgarten/server'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { botgarten } from './testing.ts'

let data: string
beforeEach(() => void (data = mkdtempSync(join(tmpdir(), 'botgarten-cli-'))))
afterEach(() => rmSync(data, { recursive: true, force: true }))

const teacher = { username: 'm.weber', password: 'kastanie im regen' }

async function withTeacher() {
  const server = await openClassServer({ data })
  await server.ports.accounts.create(teacher)
  return server
}

test.each([['abc'], ['65536'], ['80.5'], ['1e99']])('%s is refused as a port', async (port) => {
  const { status, stderr } = await botgarten('serve', '--port', port, '--data', data)
  expect(status).toBe(2)
  expect(stderr).toContain('--port takes')
})

test.each([
  [['--prot', '1']],
  [['8080']],
  [['--port']],
  [['--database', 'mysql://x']],
  [['--public-address', 'lab']],
])('serve %j is refused', async (args) =>
  expect((await botgarten('serve', '--data', data, ...args)).status).toBe(2),
)

test('a backup is made while a server runs, and is not put back while it does', async () => {
  const server = await withTeacher()
  const file = join(data, 'copy.db')
  expect((await botgarten('backup', file, '--data', data)).status).toBe(0)
  const refused = await botgarten('restore', file, '--data', data)
  expect(refused).toMatchObject({ status: 1 })
  expect(refused.stderr).toContain('running on')
  await server.close()
  const restored = await botgarten('restore', file, '--data', data)
  expect(restored).toMatchObject({ status: 0 })
  expect(restored.stdout).toContain('before-restore')
  const again = await openClassServer({ data })
  expect(await again.ports.database.db.selectFrom('teacher').select('username').execute()).toEqual([
    { username: 'm.weber' },
  ])
  await again.close()
})

test('what is no backup changes nothing', async () => {
  await (await withTeacher()).close()
  const before = readFileSync(join(data, 'botgarten.db'))
  writeFileSync(join(data, 'holiday.jpg'), 'x'.repeat(5000))
  const { status, stderr } = await botgarten('restore', join(data, 'holiday.jpg'), '--data', data)
  expect(status).toBe(1)
  expect(stderr).toContain('no sound backup')
  expect(readFileSync(join(data, 'botgarten.db')).equals(before)).toBe(true)
})

test('a teacher who has forgotten the password gets a new one, by the console or by a file', async () => {
  await (await withTeacher()).close()
  const { stdout } = await botgarten('teacher', 'reset', 'M.Weber', '--data', data)
  expect(stdout).toMatch(/^The new password of M\.Weber: [a-z]+(-[a-z]+){3}\n$/)
  expect((await botgarten('teacher', 'reset', 'nobody', '--data', data)).status).toBe(1)
  writeFileSync(join(data, 'reset-teacher.txt'), 'm.weber\n')
  const server = await openClassServer({ data })
  const password = readFileSync(join(data, 'new-password.txt'), 'utf8').trim()
  const body = JSON.stringify({ username: 'm.weber', password })
  const caller = { address: '192.0.2.1', secure: false, reached: null }
  const signedIn = await server.ports.accounts.forward('/sign-in/username', new Headers(), body, caller)
  expect(signedIn.status).toBe(200)
  await server.close()
})

test(
  'a rehearsal prints its figures as one line of JSON, and leaves nothing',
  { timeout: 60_000 },
  async () => {
    const { stdout } = await botgarten('serve', '--rehearse', '2', '--seconds', '1', '--json', '--data', data)
    // On a machine that is busy with tests it may be red.
    process.exitCode = undefined
    const figures = JSON.parse(stdout) as Record<string, number>
    expect(Object.keys(figures)).toEqual(['pupils', 'saves', 'lost', 'p99', 'rss'])
    expect(figures).toMatchObject({ pupils: 2, lost: 0 })
    expect(figures['saves']).toBeGreaterThan(0)
    expect(readdirSync(data).filter((name) => name.startsWith('rehearsal-'))).toEqual([])
  },
)
