import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { draw, stream } from '@botgarten/numbers'
import { isLong } from '@botgarten/numbers/testing'
import { describe, expect, test } from 'vitest'
import { migrate } from '../database/migrate.ts'
import { open } from '../testing/child-process.ts'
import { KilledServer } from '../testing/killed.ts'
import { noPostgres, startPostgres } from '../testing/postgres.ts'
import { projectText } from '../testing/projects.ts'
import { Server } from '../testing/world.ts'

const total = isLong ? 1000 : 150
const children = 5
/** On average so many saves between two kills. */
const between = isLong ? 40 : 50

/** Five children save without a pause, each save on the one before, while the server is killed at random. */
async function saveWhileKilled(address: string): Promise<{ kills: number }> {
  const database = open(address)
  await migrate(database)
  const setup = new Server(database)
  const teacher = await setup.firstTeacher()
  const { code } = await setup.openClass(teacher)
  const pupils = []
  for (let at = 0; at < children; at++) pupils.push(await setup.pupil(code, `Kind ${at}`))
  await database.close()

  const server = new KilledServer(address)
  await server.start()
  const chance = stream(1, 'kill')
  let [done, kills] = [0, 0]
  let alive = Promise.resolve()

  function killNow() {
    kills++
    alive = (async () => {
      await server.kill()
      await server.start()
    })()
  }

  const acknowledged = await Promise.all(
    pupils.map(async ({ browser }) => {
      const cookie = [...browser.cookies].map(([name, value]) => `${name}=${value}`).join('; ')
      const headers = { cookie, origin: 'http://lab.test', 'content-type': 'application/json' }
      let [revision, mark] = [0, 0]
      let isAnswered = true
      // What was not answered may have been saved all the same: the device asks until it knows.
      while (done < total || !isAnswered) {
        await alive
        const path = `/projects/project-1?base=${revision}&save=save-number-${mark}`
        const reply = await server.ask({ method: 'PUT', path, headers, body: projectText(`${mark}`) })
        isAnswered = reply !== null
        // Without an answer the device sends the same save again.
        if (!reply) continue
        expect(reply, reply.text).toMatchObject({ status: 200 })
        revision = (JSON.parse(reply.text) as { revision: number }).revision
        // Each save is one revision: none is lost, none is there twice.
        expect(revision).toBe(mark + 1)
        mark++
        done++
        if (draw(chance) < 1 / between) killNow()
      }
      return { browser, mark }
    }),
  )
  await alive
  await server.kill()

  const again = open(address)
  const reader = new Server(again)
  for (const { browser, mark } of acknowledged) {
    const child = reader.browser()
    for (const [name, value] of browser.cookies) child.cookies.set(name, value)
    const { body } = await child.get('/projects/project-1')
    expect(body).toMatchObject({ revision: mark, project: { name: `Garden ${mark - 1}` } })
  }
  await again.close()
  return { kills }
}

describe(`${total} saves while the server is killed at random: nothing acknowledged is lost, nothing is there twice`, () => {
  test('on SQLite', { timeout: 600_000 }, async () => {
    const folder = mkdtempSync(join(tmpdir(), 'botgarten-kill-'))
    const { kills } = await saveWhileKilled(join(folder, 'class.db'))
    rmSync(folder, { recursive: true, force: true })
    expect(kills).toBeGreaterThan(0)
  })

  const why = noPostgres()
  test.skipIf(why !== null)(
    `on PostgreSQL${why ? ` (skipped: ${why})` : ''}`,
    { timeout: 600_000 },
    async () => {
      const postgres = await startPostgres({ fsync: true })
      const { kills } = await saveWhileKilled(await postgres.newDatabase())
      await postgres.stop()
      expect(kills).toBeGreaterThan(0)
    },
  )
})
