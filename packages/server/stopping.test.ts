import { once } from 'node:events'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { openClassServer } from './class-server.ts'
import { Client } from './rehearsal/client.ts'
import { startNode } from './rehearsal/node.ts'
import { projectOfLesson } from './rehearsal/projects.ts'

let data: string
beforeEach(() => void (data = mkdtempSync(join(tmpdir(), 'botgarten-stopping-'))))
afterEach(() => rmSync(data, { recursive: true, force: true }))

/** A class that can be joined, and children in it. */
async function childrenOf(url: string, token: string): Promise<readonly Client[]> {
  const teacher = new Client(url)
  await teacher.untilDone('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const about = { name: '5b', language: 'en', grade: 5, endsOn: '2099-01-31' }
  const { id } = await teacher.untilDone<{ id: string }>('POST', '/classes', about)
  await teacher.untilDone('POST', `/classes/${id}/open`)
  const { words } = await teacher.untilDone<{ words: string[] }>('GET', `/classes/${id}`)
  const children = Array.from({ length: 5 }, () => new Client(url))
  for (const [at, child] of children.entries())
    await child.untilDone('POST', '/join', { code: words.join(' '), nickname: `Kind ${at}` })
  return children
}

/** Saves until nobody answers. @returns how many saves were acknowledged */
async function saveUntilGone(child: Client, at: number, hear: () => void): Promise<number> {
  for (let saved = 0; ; saved++) {
    const path = `/projects/project-${at}?base=${saved}&save=save-number-${saved}`
    const answer = await child.ask('PUT', path, projectOfLesson(`save ${saved}`, at)).catch(() => null)
    if (answer?.status !== 200) return saved
    hear()
  }
}

// SIGTERM is what a system sends, SIGHUP what a window that is closed sends, SIGINT is Ctrl+C.
test.each(['SIGTERM', 'SIGHUP', 'SIGINT'] as const)(
  '%s during saves: it ends by itself, and what was acknowledged is there',
  async (signal) => {
    const node = await startNode({ data })
    const children = await childrenOf(node.url, node.token())
    let heard = 0
    const hear = () => {
      heard += 1
      if (heard === 30) node.process.kill(signal)
    }
    const ended = once(node.process, 'exit')
    const acknowledged = await Promise.all(children.map((child, at) => saveUntilGone(child, at, hear)))
    expect(await ended).toEqual([0, null])

    const server = await openClassServer({ data })
    const rows = await server.ports.database.db.selectFrom('project').select(['id', 'revision']).execute()
    for (const [at, count] of acknowledged.entries()) {
      // One that was on its way may be there without its answer.
      const { revision } = rows.find(({ id }) => id === `project-${at}`)!
      expect([count, count + 1]).toContain(revision)
    }
    await server.close()
  },
)
