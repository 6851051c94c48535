// `node e2e/saved-work.ts <folder>`: what children's devices and files hold today, written by the product itself as a
// child would make it, with what a run of it gives. What this has written once is never written again: later products
// have to open it.
import { content } from '@botgarten/content/files'
import { execFileSync } from 'node:child_process'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { courseOf } from '@botgarten/maps'
import { learningIn, type Project } from '@botgarten/programs'
import { expect, type Page } from '@playwright/test'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { inHouse } from '../scripts/prepare/house.mjs'
import { startServer } from '../scripts/server.ts'
import { launchBrowser } from './browser.ts'
import { bigFile } from './big-file.ts'
import { Builder } from './child-build.ts'
import { opensSettings, option } from './child-cards.ts'
import { Learner } from './child-learning.ts'
import { NetHands } from './child-network.ts'
import { Comer } from './child-open-roberta.ts'
import { ProjectList } from './child-projects.ts'
import { SortingHands, sortingProject } from './child-sorting.ts'
import { TimeHands } from './child-time.ts'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from './child.ts'
import { grey, picture } from './png.ts'
import { freeProgram, projectFile } from './projects.ts'

const folder = process.argv[2]
if (!folder) throw new Error('Which folder?')

/** Friendship, solved from its first place, with a hint. */
async function solvesFriendship(child: Child) {
  await child.opensLabByAddress('friendship')
  await child.presses('lab.hint')
  await child.typesWeight(leftEye, leftWheel, 0.8)
  await child.typesWeight(rightEye, rightWheel, 0.8)
  await child.pressesStart()
  await new TimeHands(child).hurries()
  await expect(child.page.getByText(child.word('lab.successTitle')).first()).toBeVisible({ timeout: 60_000 })
  await child.seesSaved()
}

/** Fear: two sets of weights with names, and a second robot with a program and weights of its own. */
async function namesWeights(child: Child): Promise<string> {
  const [net, robots] = [new NetHands(child), new TimeHands(child)]
  await child.opensLabByAddress('fear')
  await child.typesWeight(leftEye, rightWheel, 0.8)
  await child.typesWeight(rightEye, leftWheel, 0.75)
  await net.opensShelf()
  await net.putsOnShelf('mild')
  const [download] = await Promise.all([
    child.page.waitForEvent('download'),
    child.presses('net.save', { name: 'mild' }),
  ])
  await child.types('Escape')
  await child.typesWeight(leftEye, leftWheel, 0.35)
  await net.opensShelf()
  await net.putsOnShelf('Wilde Äpfel')
  await child.types('Escape')
  await robots.adds('own')
  await child.seesSaved()
  return readFileSync(await download.path(), 'utf8')
}

/** A network with a hidden layer, with a bias set by hand. */
async function buildsDeepNet(child: Child) {
  const net = new NetHands(child)
  await child.opensLabByAddress('free')
  const file = projectFile('friendship', 'start').replace('"name":"Friendship"', '"name":"Deep"')
  await child.opensProject('Deep', file)
  await net.chooses('explorer')
  await child.presses('net.addLayer')
  await expect(net.layer(1)).toBeVisible()
  for (const [index, knob] of (await child.knobs.all()).entries()) {
    await knob.focus()
    await child.types(...`0.${index + 1}`, 'Enter')
  }
  const first = child.word('net.hidden', { layer: 1, neuron: 1 })
  await child.knobs.first().focus()
  await net.bias(first).fill('-12', { timeout: 5000 })
  await net.bias(first).press('Enter')
  await child.seesSaved()
}

/** The free lab on a floor of the child's own, with a wall. */
async function buildsWorld(child: Child): Promise<string> {
  await child.opensLabByAddress('free')
  const builder = new Builder(child)
  await builder.begins()
  await builder.choosesFile('build.ownPicture', 'map.png', picture(300, 200), 'image/png')
  await expect.poll(() => child.painted.floorColour()).toBe(grey)
  await builder.addsThing('circle')
  const scene = await builder.savesScene()
  await builder.ends()
  await child.seesSaved()
  return scene
}

/** Railway learned to the end, and Forest left in the middle of it. */
async function learns(child: Child) {
  const learner = new Learner(child)
  await learner.opens('railway')
  await learner.learnsToTheEnd()
  await child.seesSaved()
  await learner.opens('forest')
  await learner.learns()
  await expect.poll(async () => (await learner.moves()).made, { timeout: 60_000 }).toBeGreaterThan(6)
  await child.presses('q.pause')
  await child.seesSaved()
}

/** Colours that the robot has collected, sorted, one group with a name; and points of a table on the device. */
async function sorts(child: Child) {
  const sorting = new SortingHands(child)
  await child.opensLabByAddress('new-colours')
  await child.opensProject('Mine', sortingProject('new-colours', 'solution'))
  await child.pressesStart()
  await new TimeHands(child).hurries()
  await child.seesCheck('new-colours', 'shows', true, 60_000)
  await child.presses('lab.menu')
  await child.presses('robot.collected')
  await expect(sorting.flags).toHaveCount(3)
  await sorting.sorts()
  await sorting.group(1).fill('Himmel')
  await child.seesSaved()
  await sorting.opens('points')
  await sorting.opensTable('x,y\n1,2\n1.5,2.25\n8,9\n9,8\n8.5,8.75\n20,1\n21,2\n')
  await sorting.seesPoints(7)
  await sorting.sorts()
  await sorting.group(2).fill('Ecke')
}

/** A file of Open Roberta with a block that no lab knows. */
async function comesFromOpenRoberta(child: Child) {
  const comer = new Comer(child)
  await child.opensLabByAddress('free')
  const unknown = '<block type="robActions_fromTomorrow" id="x1"><field name="A">b</field></block>'
  await comer.opens('Roberta.xml', bigFile(2, 2).replace(/<\/instance><\/block_set>/, `${unknown}$&`))
  await comer.seesProgram('Roberta')
}

async function fillsBin(child: Child) {
  const list = new ProjectList(child)
  await list.opens()
  await list.opensFile(
    'Uno.json',
    freeProgram('Uno', (make) => [make.wait(500)]),
  )
  await expect(child.page.getByRole('heading', { level: 1 })).toHaveText('Uno')
  await list.opens()
  const [fear, free] = [child.card('fear'), child.word('session.free')]
  await list.chooses(fear, 'duplicate')
  await list.chooses(free, 'duplicate')
  const copies = [fear, free].map((name) => child.word('session.copy', { name }))
  for (const name of ['Uno', ...copies]) {
    await list.chooses(name, 'throw')
    await list.hears('projects.thrown', { name })
  }
}

async function setsUp(child: Child) {
  await child.opensLabByAddress('friendship')
  await child.presses('lab.soundOff')
  const border = child.page.getByRole('separator', { name: child.word('lab.borderProgram') })
  await border.focus()
  await child.types('ArrowRight', 'ArrowRight')
  await child.presses('lab.worldSettings')
  await child.page.getByText(child.word('lab.rays'), { exact: true }).click()
  await child.types('Escape')
  await child.opensHome()
  await opensSettings(child, 'home')
  await option(child, 'letters').click()
  await child.types('Escape')
  await child.speaks('de')
}

/** Every record of the device, as it stands there. */
const device = (page: Page) =>
  page.evaluate(async () => {
    const [{ name, version }] = (await indexedDB.databases()) as [{ name: string; version: number }]
    const opened = await new Promise<IDBDatabase>((done) => {
      const asked = indexedDB.open(name)
      asked.onsuccess = () => done(asked.result)
    })
    const stores: { [store: string]: unknown[] } = {}
    for (const store of opened.objectStoreNames)
      stores[store] = await new Promise((done) => {
        const asked = opened.transaction(store).objectStore(store).getAll()
        asked.onsuccess = () => done(asked.result)
      })
    opened.close()
    return { name, version, stores, localStorage: { ...localStorage } }
  })

/** What the command line says of a project: the hash of its first 20 seconds. */
function hashOf(project: Project): string {
  const path = join(tmpdir(), `saved-work-${process.pid}.json`)
  writeFileSync(path, JSON.stringify(project))
  const botgarten = inHouse('apps', 'cli', 'botgarten.ts')
  const line = execFileSync(
    process.execPath,
    [botgarten, 'run', path, '--seconds', '20', '--seed', '7', '--json'],
    { encoding: 'utf8' },
  )
  return (JSON.parse(line) as { hash: string }).hash
}

/** The Q-values that a project's program has learned so far. */
function learnedIn({ programs, q }: Project): readonly number[] | undefined {
  const [[id, learned] = []] = Object.entries(q ?? {})
  const outline = id === undefined ? null : learningIn(programs[id]!)
  if (!outline || !learned) return undefined
  const map = content.mapFile(outline.map)
  const course = courseOf(outline, map!, learned.seed)
  course.advance(learned.moves)
  return [...course.learner.q]
}

function write(path: string, text: string) {
  writeFileSync(join(folder!, path), text)
}
const lines = (data: unknown) => `${JSON.stringify(data, null, 1)}\n`

await buildWhenNeeded()
const server = await startServer({ port: 0, host: '127.0.0.1' })
const browser = await launchBrowser()
const context = await browser.newContext({
  ...{ baseURL: server.url, locale: 'en-GB', viewport: { width: 1366, height: 768 } },
})
await context.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
const child = new Child(await context.newPage(), 'en')
mkdirSync(join(folder, 'files'), { recursive: true })

await solvesFriendship(child)
const brain = await namesWeights(child)
await buildsDeepNet(child)
const scene = await buildsWorld(child)
await learns(child)
await sorts(child)
await comesFromOpenRoberta(child)
await fillsBin(child)
await setsUp(child)

const list = new ProjectList(child)
await list.opens()
const links: { [name: string]: string } = {}
await expect.poll(() => list.names()).toHaveLength(8)
for (const name of await list.names()) {
  const [download] = await Promise.all([child.page.waitForEvent('download'), list.chooses(name, 'saveFile')])
  write(join('files', download.suggestedFilename()), readFileSync(await download.path(), 'utf8'))
  await list.chooses(name, 'share')
  const tooLarge = child.dialog('share.tooLargeTitle')
  await expect(
    child.page.getByRole('textbox', { name: child.word('share.address') }).or(tooLarge),
  ).toBeVisible()
  if (!(await tooLarge.isVisible())) links[name] = (await list.link()).split('#')[1]!
  await child.types('Escape')
}
const home = await list.takesHome()
write('home.botgarten.json', home)
write('brain.brain.json', brain)
write('scene.json', scene)
write('links.json', lines(links))
const records = await device(child.page)
write('device.json', lines(records))
const projects = Object.values(records.stores).flat() as { id: string; project: Project }[]
const expected = projects.map(({ id, project }) => [id, { hash: hashOf(project), q: learnedIn(project) }])
write('expected.json', lines(Object.fromEntries(expected)))
await browser.close()
await server.close()
