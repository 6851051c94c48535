// Rooms: address, class, storage, server
// By address: the same server under two addresses, which old links and bookmarks still have.
import { once } from 'node:events'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { createServer, type AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Page } from '@playwright/test'
import { openClassServer, startServer } from '../../packages/server/index.ts'
import { flags } from '../browser.ts'
import { Child } from '../child.ts'
import { Pupil } from '../child-class.ts'
import { ProjectList } from '../child-projects.ts'
import { findChromium } from '../chromium.mjs'
import { Asker } from '../class-server.ts'
import { expect, test as base } from '../house.ts'

/** Two names that lead to this machine: the one that is announced, and one that a class used before. */
const [announced, before] = ['garden.test', 'laptop.test'] as const

async function freePort(): Promise<number> {
  const server = createServer().listen(0, '127.0.0.1')
  await once(server, 'listening')
  const { port } = server.address() as AddressInfo
  server.close()
  return port
}

/** A server that announces one of its names, with a class that can be joined. */
async function roomOfTest() {
  const [data, port] = [mkdtempSync(join(tmpdir(), 'botgarten-address-')), await freePort()]
  const there = `http://${announced}:${port}`
  const classServer = await openClassServer({ data, publicAddress: there })
  const server = await startServer({ port, host: '127.0.0.1', classServer })
  const teacher = new Asker(server.url)
  const token = await classServer.firstTeacher()
  await teacher.ask('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const about = { name: '5b', language: 'en', grade: 5, endsOn: classServer.ports.day(120) }
  const { id } = (await teacher.ask('POST', '/classes', about)).body as { id: string }
  await teacher.ask('POST', `/classes/${id}/open`)
  const { words } = (await teacher.ask('GET', `/classes/${id}`)).body as { words: readonly string[] }
  const close = async () => (await server.close(), rmSync(data, { recursive: true, force: true }))
  return { ...{ there, here: `http://${before}:${port}`, code: words.join(' '), teacher, id, close } }
}

const test = base.extend<{ room: Awaited<ReturnType<typeof roomOfTest>> }>({
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
  room: async ({}, use) => {
    const room = await roomOfTest()
    await use(room)
    await room.close()
  },
  baseURL: ({ room }, use) => use(room.here),
})
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
test.use({
  complaints: [/^A request to http:\/\/(garden|laptop)\.test:\d+\/|net::ERR_FAILED/],
  launchOptions: {
    executablePath: findChromium() ?? undefined,
    args: [...flags, '--host-resolver-rules=MAP *.test 127.0.0.1'],
  },
})

const projectsIn = async ({ teacher, id }: { teacher: Asker; id: string }) =>
  ((await teacher.ask('GET', `/classes/${id}`)).body as { projects: number }).projects

const cards = ['friendship', 'fear', 'crossed-wires']
/** Saves on their way to the class. */
const saves = '**/api/class/projects/**'

const seesKnob = (child: Child) => expect(child.knobs.first()).toHaveAttribute('aria-valuenow', '0.7')

/** Turns a knob of each card; it is saved on the device. */
async function works(child: Child, seesSaved: (works: number) => Promise<void>) {
  for (const [before, card] of cards.entries()) {
    await child.opensLab(card)
    await child.knobs.first().focus()
    for (const key of '0.7') await child.page.keyboard.press(key)
    await child.page.keyboard.press('Enter')
    await seesKnob(child)
    await seesSaved(before + 1)
  }
}

/** How many works this device keeps of the child that sits there: a pupil has a database of its own. */
const keptIn = (page: Page) =>
  page.evaluate(async () => {
    const names = (await indexedDB.databases()).map(({ name }) => name!)
    const name = names.find((one) => one.startsWith('botgarten-'))
    if (name === undefined) return 0
    return new Promise<number>((done) => {
      const asked = indexedDB.open(name)
      asked.onsuccess = () => {
        const count = asked.result.transaction('revisions').objectStore('revisions').count()
        count.onsuccess = () => (asked.result.close(), done(count.result))
      }
    })
  })

/** What the sheet that leads away says. */
const leads = (child: Child, key: string, facts = {}) =>
  expect(child.page.getByRole('dialog')).toContainText(child.word(`address.${key}`, facts))

test('three saves that did not come to the class are sent from the old address; nothing is mixed, nothing is lost', async ({
  child,
  page,
  context,
  room,
}) => {
  test.setTimeout(240_000)
  const fox = new Pupil(child, room)
  let pictures: readonly string[] = []
  await test.step('a child joins under the old address and stays there', async () => {
    await page.goto(`/join#${room.code.replaceAll(' ', '-')}`)
    await leads(child, 'nothing')
    const way = page.getByRole('link', { name: child.word('address.go') })
    await expect(way).toHaveAttribute('href', `${room.there}/join#${room.code.replaceAll(' ', '-')}`)
    await child.presses('address.stay')
    pictures = await fox.joins('Fuchs')
    await fox.remembers()
    await context.route(saves, (route) => route.abort())
    await works(child, async (works) => {
      await expect(fox.chip('chipHere')).toBeVisible()
      // The chip said so of the work before, too.
      await expect.poll(() => keptIn(page)).toBe(works)
    })
    await expect.poll(() => projectsIn(room)).toBe(0)
    await page.close()
  })

  const later = new Child(await context.newPage(), 'en')
  await test.step('the next day it is told what is still here, and sends it', async () => {
    await later.page.goto('/')
    await later.presses('class.yesOn')
    await leads(later, 'waiting', { count: 3 })
    await later.presses('address.send')
    await leads(later, 'unsent')
    await context.unroute(saves)
    await later.presses('address.send')
    await leads(later, 'allInClass')
    await expect.poll(() => projectsIn(room)).toBe(3)
  })

  await test.step('under the announced address another child sees nothing of it', async () => {
    await later.page.goto(`${room.there}/join#${room.code.replaceAll(' ', '-')}`)
    const beaver = new Pupil(later, room)
    await beaver.joins('Biber')
    await beaver.remembers()
    const projects = new ProjectList(later)
    await later.page.goto(`${room.there}/projects`)
    await projects.seesNames()
    await beaver.leaves()
  })

  await test.step('who made it comes back there by its pictures and finds all', async () => {
    const back = new Pupil(later, room)
    await later.page.goto(`${room.there}/join#${room.code.replaceAll(' ', '-')}`)
    await back.returns('Fuchs')
    await back.taps(...pictures)
    await expect(later.words('class.workIsHere')).toBeVisible()
    await later.presses('class.toGarden')
    for (const card of cards) {
      await later.opensLab(card)
      await seesKnob(later)
    }
  })
})

test('without a class what is under the old address goes along as a file', async ({ child, page, room }) => {
  await child.opensLabByAddress('friendship')
  await leads(child, 'nothing')
  await child.presses('address.stay')
  await works(child, () => child.seesSaved())
  const next = new Child(await page.context().newPage(), 'en')
  await next.page.goto('/projects')
  await leads(next, 'alone', { count: 3 })
  const [download] = await Promise.all([next.page.waitForEvent('download'), next.presses('address.takeHome')])
  await leads(next, 'taken')
  const file = readFileSync(await download.path(), 'utf8')
  await next.page.goto(`${room.there}/projects`)
  const projects = new ProjectList(next)
  await projects.opensFile('home.botgarten.json', file)
  await expect.poll(() => projects.names()).toHaveLength(3)
  await expect(next.page.getByText(next.word('address.title', { host: '' }))).toHaveCount(0)
})
