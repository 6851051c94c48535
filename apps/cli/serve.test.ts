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
  const file = join(data, 'copy.age')
  const made = await botgarten('backup', file, '--data', data)
  expect(made.status).toBe(0)
  // The phrase is shown with the first backup, and from then on by its own command.
  const [phrase] = /(?:[a-z]+-){9}[a-z]+/.exec(made.stdout)!
  const next = await botgarten('backup', join(data, 'next.age'), '--data', data)
  expect(next.stdout).not.toContain(phrase)
  expect((await botgarten('phrase', '--data', data)).stdout).toContain(phrase)
  const paper = join(data, 'paper.txt')
  writeFileSync(paper, `${phrase.toUpperCase().replaceAll('-', ' ')}\n`)
  const putBack = () => botgarten('restore', file, '--phrase-file', paper, '--data', data)
  const refused = await putBack()
  expect(refused).toMatchObject({ status: 1 })
  expect(refused.stderr).toContain('running on')
  await server.close()
  const restored = await putBack()
  expect(restored).toMatchObject({ status: 0 })
  expect(restored.stdout).toContain('before-restore')
  const again = await openClassServer({ data })
  expect(await again.ports.database.db.selectFrom('teacher').select('username').execute()).toEqual([
    { username: 'm.weber' },
  ])
  await again.close()
})

test('on another machine a backup is restored with its phrase, and later deletions are reported as unknown', async () => {
  const server = await withTeacher()
  await server.close()
  const [file, paper, elsewhere] = ['copy.age', 'paper.txt', 'elsewhere'].map((name) => join(data, name))
  const { stdout } = await botgarten('backup', file!, '--data', data)
  writeFileSync(paper!, /(?:[a-z]+-){9}[a-z]+/.exec(stdout)![0])
  const call = ['restore', file!, '--phrase-file', paper!, '--data', elsewhere!]
  const restored = await botgarten(...call)
  expect(restored).toMatchObject({ status: 0 })
  expect(restored.stdout).toContain('--deleted FILE')
  expect(restored.stdout).toContain('/trust')
  const list = join(data, 'deleted.jsonl')
  writeFileSync(list, '')
  expect((await botgarten(...call, '--deleted', list)).stdout).not.toContain('--deleted FILE')
  expect((await botgarten(...call, '--deleted', join(data, 'nothing'))).stderr).toContain('does not exist')
  const again = await openClassServer({ data: elsewhere! })
  expect(await again.ports.accounts.isPassword(await teacherIn(again), teacher.password)).toBe(true)
  await again.close()
})

const teacherIn = async ({ ports }: Awaited<ReturnType<typeof openClassServer>>) =>
  (await ports.database.db.selectFrom('teacher').select('id').executeTakeFirstOrThrow()).id

test('an unusable backup is refused with its reason and changes nothing', async () => {
  await (await withTeacher()).close()
  const [file, paper, cut] = ['copy.age', 'paper.txt', 'cut.age'].map((name) => join(data, name))
  await botgarten('backup', file!, '--data', data)
  const before = readFileSync(join(data, 'botgarten.db'))
  writeFileSync(paper!, 'ten other words')
  writeFileSync(cut!, readFileSync(file!).subarray(0, 5000))
  const answer = await botgarten('restore', file!, '--phrase-file', paper!, '--data', data)
  expect(answer.stderr).toContain('misread')
  const { stdout } = await botgarten('phrase', '--data', data)
  writeFileSync(paper!, /(?:[a-z]+-){9}[a-z]+/.exec(stdout)![0])
  const cutAnswer = await botgarten('restore', cut!, '--phrase-file', paper!, '--data', data)
  expect(cutAnswer).toMatchObject({ status: 1 })
  expect(cutAnswer.stderr).toContain('not complete')
  expect(readFileSync(join(data, 'botgarten.db')).equals(before)).toBe(true)
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
  const signedIn = await server.ports.accounts.forward('/sign-in/username', new Headers(), body)
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
