// Rooms: scripts, server
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { text } from 'node:stream/consumers'
import { expect, test } from '@playwright/test'
import { inHouse } from '../../scripts/prepare/house.mjs'

const folders: string[] = []
test.afterAll(() => folders.forEach((folder) => rmSync(folder, { recursive: true, force: true })))

/** What `npm start` runs, on a data folder that nobody has used. */
function call(port: number): string[] {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-start-'))
  folders.push(folder)
  return [
    inHouse('apps', 'cli', 'botgarten.ts'),
    'serve',
    '--port',
    String(port),
    '--data',
    folder,
    '--lang',
    'en',
  ]
}

/** The last step of `npm start`, as a process of its own. */
const serve = (port: number, env = {}) =>
  spawn(process.execPath, call(port), { env: { ...process.env, ...env } })

async function opened(process = serve(0)) {
  let said = ''
  process.stdout.on('data', (part) => (said += String(part)))
  await expect.poll(() => said).toContain('Ctrl+C')
  const port = Number(/http:\/\/localhost:(\d+)/.exec(said)?.[1])
  return { process, said, port }
}

test('npm start says where the lab is open, and closes when it is told to', async () => {
  const { process, said, port } = await opened()
  expect(said).toContain('Botgarten is open at')
  for (const host of ['127.0.0.1', 'localhost']) {
    expect((await fetch(`http://${host}:${port}/`)).status).toBe(200)
  }
  process.kill('SIGTERM')
  expect(await once(process, 'exit')).toEqual([0, null])
  await expect(fetch(`http://127.0.0.1:${port}/`)).rejects.toThrow()
})

test('a busy port is answered by one sentence with a way out', async () => {
  const first = await opened()
  const second = serve(first.port)
  const [complaint, ended] = await Promise.all([text(second.stderr), once(second, 'exit')])
  expect(complaint.trim()).toBe(
    `botgarten: Port ${first.port} is taken by another program. Choose another one: npm start -- --port ${first.port + 1}`,
  )
  expect(ended).toEqual([1, null])
  first.process.kill('SIGINT')
  expect(await once(first.process, 'exit')).toEqual([0, null])
})

test('a server whose shell is killed, as npm kills its own, does not stay behind', async () => {
  const script = `"${process.execPath}" ${call(0)
    .map((word) => `"${word}"`)
    .join(' ')}; :`
  const env = { ...process.env, BOTGARTEN_ENDS_WITH_PARENT: '1' }
  const { process: shell, port } = await opened(spawn('sh', ['-c', script], { env }))
  shell.kill('SIGTERM')
  const answer = () =>
    fetch(`http://127.0.0.1:${port}/`).then(
      ({ status }) => status,
      () => 'gone',
    )
  await expect.poll(answer).toBe('gone')
})

test('an operator file that is not there is one sentence', async () => {
  const missing = serve(0, { BOTGARTEN_OPERATOR: '/nope' })
  const [complaint, ended] = await Promise.all([text(missing.stderr), once(missing, 'exit')])
  expect(complaint.trim()).toMatch(
    /^botgarten: BOTGARTEN_OPERATOR names a file that cannot be read \(ENOENT\): \/nope\. .+$/,
  )
  expect(ended).toEqual([1, null])
})
