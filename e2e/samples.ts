// `npm run samples:browser -- FOLDER`: data that browsers of this version make, for tests of later versions: the profile of a pupil's
// device with the data folder of its class, links of every kind, and the log of a study. To make them for an earlier version,
// copy this file into a checkout of it. Each sample has the commit that made it in its name.
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { BrowserContext, Page } from '@playwright/test'
import { openClassServer, startServer } from '../packages/server/index.ts'
import { launchBrowser } from './browser.ts'
import { Pupil } from './child-class.ts'
import { ProjectList } from './child-projects.ts'
import { StudyHands } from './child-study.ts'
import { SortingHands } from './child-sorting.ts'
import { Asker } from './class-server.ts'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from './child.ts'

const folder = process.argv[2]
if (folder === undefined) throw new Error('The folder is missing.')
mkdirSync(folder, { recursive: true })
const write = (name: string, data: unknown) =>
  writeFileSync(join(folder, name), `${JSON.stringify(data, null, 1)}\n`)

const data = join(folder, 'class')
const classServer = await openClassServer({ data })
const server = await startServer({ port: 0, host: '127.0.0.1', classServer })
const browser = await launchBrowser()

async function device(): Promise<{ context: BrowserContext; child: Child }> {
  const context = await browser.newContext({
    ...{ baseURL: server.url, locale: 'en-GB', viewport: { width: 1366, height: 768 } },
  })
  await context.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
  return { context, child: new Child(await context.newPage(), 'en') }
}

/** Every database of the page's origin. Records of this version are JSON. */
const databasesOf = (page: Page) =>
  page.evaluate(async () => {
    const done = <Result>(request: IDBRequest<Result>) =>
      new Promise<Result>((resolve, reject) => {
        request.onsuccess = () => resolve(request.result)
        request.onerror = () => reject(request.error!)
      })
    const databases = []
    for (const { name, version } of await indexedDB.databases()) {
      const database = await done(indexedDB.open(name!))
      const stores = []
      for (const store of database.objectStoreNames) {
        const from = database.transaction(store).objectStore(store)
        stores.push({ name: store, keyPath: from.keyPath, records: (await done(from.getAll())) as unknown[] })
      }
      database.close()
      databases.push({ name: name!, version: version!, stores })
    }
    return databases
  })

async function makeClass() {
  const teacher = new Asker(server.url)
  const token = await classServer.firstTeacher()
  await teacher.ask('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const about = { name: '5b', language: 'en', grade: 5, endsOn: '2099-07-31' }
  const { id } = (await teacher.ask('POST', '/classes', about)).body as { id: string }
  await teacher.ask('POST', `/classes/${id}/open`)
  const { words } = (await teacher.ask('GET', `/classes/${id}`)).body as { words: readonly string[] }
  return { teacher, id, words }
}

const { teacher, id, words } = await makeClass()

/** Without a class: a card with a weight that is saved on the device. */
async function turns(child: Child) {
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.45)
  await child.seesSaved()
}

/** Readings, named groups of objects, and points by hand: on the page of sorting, which was no project until November 2026. */
async function sorts(child: Child) {
  const sorting = new SortingHands(child)
  await sorting.opens('readings')
  await sorting.presses('drive.lanes')
  await child.page.getByText(/^[2-9]\d /).waitFor()
  await sorting.presses('drive.stop')
  await sorting.presses('tab.things')
  await sorting.sorts()
  await sorting.group(1).fill('Bottles')
  await sorting.presses('tab.points')
  await child.page.getByRole('combobox').first().selectOption('')
  await sorting.presses('tool.add')
  const { x, y } = await sorting.middleOfPlane()
  for (const [right, down] of [
    ...([[-200, -100], [-180, -120], [-190, -80]] as const), // prettier-ignore
    ...([[150, 100], [170, 90], [160, 120], [0, 10]] as const), // prettier-ignore
  ])
    await child.page.mouse.click(x + right, y + down)
  for (const _ of ['second flag', 'third flag']) await sorting.presses('moreFlags')
  await sorting.sorts()
  await sorting.group(2).fill('Mine')
}

/** Work without a class, work in a class, and a change that the class has not got yet. */
async function makeProfile() {
  const { context, child } = await device()
  await turns(child)
  await child.presses('lab.soundOff')
  await sorts(child)
  const pupil = new Pupil(child, { code: words.join(' ') })
  await pupil.opensByLink()
  const pictures = await pupil.joins('Fuchs')
  await pupil.remembers()
  await sorts(child)
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.8)
  await pupil.chip('chipClass').waitFor()
  await child.opensLab('fear')
  await child.typesWeight(leftEye, rightWheel, 0.6)
  await pupil.chip('chipClass').waitFor()
  await context.setOffline(true)
  await child.typesWeight(rightEye, leftWheel, 0.7)
  await pupil.chip('chipHere').waitFor()
  const { cookies } = await context.storageState()
  const localStorage = await child.page.evaluate(() => ({ ...window.localStorage }))
  const databases = await databasesOf(child.page)
  write('profile.json', { origin: server.url, pictures, cookies, localStorage, databases })
  await context.close()
}

/** Addresses that this version writes into links and QR codes, without the server's own. */
async function makeLinks() {
  const { context, child } = await device()
  await turns(child)
  await child.presses('lab.menu')
  await child.presses('parts.share')
  const project = await new ProjectList(child).link()
  const tokenOf = async (path: string) => ((await teacher.ask('POST', path)).body as { token: string }).token
  write('links.json', {
    project: project.slice(server.url.length),
    join: `/join#${words.join('-')}`,
    invitation: `/teacher/start#${await tokenOf('/invitations')}`,
    substitute: `/teacher/substitute#${await tokenOf(`/classes/${id}/substitute`)}`,
    projector: `/teacher/projector?class=${id}`,
    teacher: `/teacher?class=${id}&view=data`,
    cage: '/zoo?cage=volcano',
    sheet: '/materials/card/friendship?paper',
  })
  await context.close()
}

/** A child says yes, drives, changes a weight and ends. */
async function makeStudyLog() {
  const { context, child } = await device()
  const hands = new StudyHands(child)
  await hands.handsOut()
  await hands.begins(1, 2)
  await hands.opensCard('friendship')
  await child.pressesStart()
  await child.typesWeight(leftEye, leftWheel, 0.8)
  await child.seesDriving()
  await child.pressesStop()
  await hands.ends()
  await hands.saysWord()
  writeFileSync(join(folder!, 'study.jsonl'), (await hands.takesLogs()).text)
  await context.close()
}

await makeLinks()
await makeStudyLog()
await makeProfile()
await browser.close()
await server.close()
