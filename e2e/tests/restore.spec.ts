// Rooms: class, storage
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { backup, phraseOf, restore } from '../../packages/classroom/index.ts'
import { openClassServer, startServer } from '../../packages/server/index.ts'
import { Child, leftEye, leftWheel } from '../child.ts'
import { Pupil } from '../child-class.ts'
import { ProjectList } from '../child-projects.ts'
import { firstTeacher, nextClass } from '../class-server.ts'
import { expect, test } from '../house.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
// A server that is stopped is not reached, and a browser complains of it.
test.use({ complaints: [/net::ERR_/] })

/** A class whose server can be stopped, restored and started again at the same address. */
async function classOnDisk() {
  const data = mkdtempSync(join(tmpdir(), 'botgarten-restore-'))
  const start = async (port: number) => {
    const classServer = await openClassServer({ data })
    return { ...(await startServer({ port, host: '127.0.0.1', classServer })), classServer }
  }
  let server = await start(0)
  const { code } = await nextClass({ ...server, teacher: await firstTeacher(server) }, 'en')
  const file = join(data, 'copy.age')
  let phrase = ''
  return {
    url: server.url,
    code,
    async backUp() {
      const { database, secret, day } = server.classServer.ports
      await backup({ database, secret, folder: data, day: day(0) }, file)
      phrase = await phraseOf(database, secret)
    },
    async restore() {
      const day = server.classServer.ports.day(0)
      await server.close()
      expect(await restore(data, file, { day, phrase })).toMatchObject({ kind: 'restored' })
      server = await start(server.port)
    },
    /** The newest weights that the class has, by card. */
    async weights(): Promise<Record<string, number>> {
      const rows = await server.classServer.ports.database.db
        .selectFrom('project')
        .innerJoin('version', (on) =>
          on.onRef('version.project', '=', 'project.id').onRef('version.revision', '=', 'project.revision'),
        )
        .select(['card', 'document'])
        .execute()
      return Object.fromEntries(rows.map(({ card, document }) => [card ?? '', turnedIn(document)]))
    },
    async close() {
      await server.close()
      rmSync(data, { recursive: true, force: true })
    },
  }
}

/** The weight of the one knob that was turned. */
const turnedIn = (document: string) => {
  const { brains } = JSON.parse(document) as { brains: object }
  return Math.max(...[...JSON.stringify(brains).matchAll(/:(-?[\d.]+)/g)].map(([, digits]) => Number(digits)))
}

const ways = {
  'its page stays open': async () => {},
  'it opens its page again': async ({ child }: Pupil) => {
    await child.page.reload()
    await child.seesLab()
  },
  'it signs out': (pupil: Pupil) => pupil.leaves(),
}

for (const [name, act] of Object.entries(ways))
  test(`after a restore of its class a child finds nothing missing: ${name}`, async ({
    browser,
    contextOptions,
  }) => {
    const school = await classOnDisk()
    const context = await browser.newContext({ ...contextOptions, baseURL: school.url, locale: 'en-GB' })
    const child = new Child(await context.newPage(), 'en')
    const pupil = new Pupil(child, school)
    await pupil.opens()
    await pupil.joins('Fuchs')
    await pupil.remembers()
    await child.opensLab('friendship')
    await child.typesWeight(leftEye, leftWheel, 0.3)
    await expect(pupil.chip('chipClass')).toBeVisible()
    await school.backUp()

    await child.typesWeight(leftEye, leftWheel, 0.7)
    await expect(pupil.chip('chipClass')).toBeVisible()
    await child.opensLab('fear')
    await child.typesWeight(leftEye, leftWheel, 0.5)
    await expect(pupil.chip('chipClass')).toBeVisible()
    await expect.poll(() => school.weights()).toEqual({ friendship: 0.7, fear: 0.5 })
    await school.restore()
    await expect.poll(() => school.weights()).toEqual({ friendship: 0.3 })

    await act(pupil)
    await expect.poll(() => school.weights(), { timeout: 60_000 }).toEqual({ friendship: 0.7, fear: 0.5 })
    if (name === 'it signs out') {
      const projects = new ProjectList(child)
      await projects.opens()
      await projects.seesNames()
    } else {
      await expect(pupil.chip('chipClass')).toBeVisible()
      await child.opensLab('friendship')
      await child.seesWeight(leftEye, leftWheel, 0.7)
    }
    await context.close()
    await school.close()
  })
