// Property: whatever happens between a device and the class, nothing is lost and nothing is doubled. The class is the real
// one on a real database; a device is a browser's database with pages of its own.
import 'fake-indexeddb/auto'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { migrate, openSqlite, type Database } from '@botgarten/classroom'
import { Server } from '@botgarten/classroom/testing'
import { isLong } from '@botgarten/numbers/testing'
import { IDBFactory } from 'fake-indexeddb'
import fc from 'fast-check'
import { afterAll, beforeAll, expect, test, vi } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { askAs, type Ask } from '#storage/ask.ts'

type Pupil = Awaited<ReturnType<Server['pupil']>>

const folder = mkdtempSync(join(tmpdir(), 'botgarten-sending-'))
let database: Database
let server: Server
let code: string
let nicknames = 0

beforeAll(async () => {
  database = openSqlite(join(folder, 'class.db'))
  await migrate(database)
  server = new Server(database)
  ;({ code } = await server.openClass(await server.firstTeacher()))
})
afterAll(async () => {
  await database.close()
  rmSync(folder, { recursive: true, force: true })
})
const newPupil = () => server.pupil(code, `Kind ${++nicknames}`)

/** What becomes of a request. `late`: it comes much later, when the device has long given up. */
type Fate = 'arrives' | 'isLost' | 'answerIsLost' | 'comesTwice' | 'late'

class Cable {
  fate: Fate = 'arrives'
  readonly #late: (() => Promise<unknown>)[] = []
  readonly ask: Ask
  readonly requests: string[] = []

  constructor({ browser, id }: Pupil, claims = id) {
    this.ask = askAs(claims, async (path, { method = 'GET', body, headers }) => {
      const deliver = async () => {
        const text = typeof body === 'string' ? body : undefined
        this.requests.push(method)
        const answer = await browser.ask(method, path.slice('/api/class'.length), text, headers as never)
        const json = answer.body === null ? null : JSON.stringify(answer.body)
        return new Response(json, { status: answer.status })
      }
      if (this.fate === 'isLost') throw new TypeError('No network.')
      if (this.fate === 'late') {
        this.#late.push(deliver)
        throw new TypeError('No network.')
      }
      if (this.fate === 'comesTwice') await deliver()
      const answer = await deliver()
      if (this.fate === 'answerIsLost') throw new TypeError('The answer is lost.')
      return answer
    })
  }

  async deliverLate() {
    for (const deliver of this.#late.splice(0)) await deliver()
  }
}

/** A browser with its database; its modules share nothing with other devices. */
async function newDevice() {
  const factory = new IDBFactory()
  const pages = async () => {
    globalThis.indexedDB = factory
    vi.resetModules()
    const { sendAll, sendNext } = await import('./sending.ts')
    const [projects, outbox, arriving, bin, { database: opened }] = await Promise.all([
      import('#storage/projects.ts'),
      import('#storage/outbox.ts'),
      import('./arriving.ts'),
      import('#storage/bin.ts'),
      import('#storage/database.ts'),
    ])
    await opened()
    return { ...projects, ...outbox, sendAll, sendNext, ...arriving, ...bin, opened }
  }
  let page = await pages()
  return {
    get page() {
      return page
    },
    /** The browser is closed and opened again: only what was written is left. */
    async crash() {
      ;(await page.opened()).close()
      page = await pages()
    },
    async clear() {
      const db = await page.opened()
      const stores = [...db.objectStoreNames]
      const transaction = db.transaction(stores, 'readwrite')
      await Promise.all(stores.map((store) => transaction.objectStore(store).clear()))
      await transaction.done
    },
  }
}
type Device = Awaited<ReturnType<typeof newDevice>>

const named = (name: string) => ({ ...friendship, name })

/** A child works with a project on a device, and every piece of work knows what it was made from. */
class Work {
  readonly parents = new Map<string, string | null>()
  #count = 0

  async edit({ page }: Device, id: string) {
    const kept = await page.load(id)
    const mark = `work ${++this.#count}`
    this.parents.set(mark, kept?.project.name ?? null)
    const saved = await page.save(id, named(mark), kept?.revision ?? 0)
    expect(saved.kind).toBe('saved')
  }

  /** Is all the work in these projects, or below what was made of it? */
  lostWith(heads: readonly string[]): readonly string[] {
    const found = new Set<string>()
    for (let mark of heads as readonly (string | null)[])
      while (mark !== null && !found.has(mark)) {
        found.add(mark)
        mark = this.parents.get(mark) ?? null
      }
    return [...this.parents.keys()].filter((mark) => !found.has(mark))
  }
}

let copies = 0
const copyOf = (project: typeof friendship) => ({ id: `copy-${++copies}`, project, changed: 1 })

async function choose({ page }: Device, cable: Cable, own: boolean) {
  for (const [id, place] of await page.whereabouts()) {
    if (place.kind !== 'conflict') continue
    const other = await page.fetchProject(cable.ask, id)
    if (!other) continue
    if (own) await page.goOnWithOwn(other, copyOf(other.project))
    else await page.goOnWithClass(other, copyOf)
  }
}

/** The cable is back: everything is sent, and asked until nothing is open. */
async function settle(devices: readonly Device[], cable: Cable, own: boolean) {
  cable.fate = 'arrives'
  await cable.deliverLate()
  for (let round = 0; ; round++) {
    expect(round).toBeLessThan(10)
    let open = 0
    for (const device of devices) {
      expect(await device.page.sendAll(cable.ask)).toBeNull()
      await choose(device, cable, own)
      await device.page.fetchWork(cable.ask)
      for (const { kind } of (await device.page.whereabouts()).values()) if (kind !== 'class') open++
    }
    if (open === 0) return
  }
}

/** Projects in the bins of devices, which can be restored. */
async function inBins(devices: readonly Device[]): Promise<readonly string[]> {
  const bins = await Promise.all(devices.map(({ page }) => page.listBin()))
  return bins.flatMap(({ thrown }) => thrown.map(({ project }) => project.name))
}

async function takeOneBack({ page }: Device) {
  const [last] = (await page.listBin()).thrown
  if (last) await page.takeBack(last.id)
}

async function headsIn({ browser }: Pupil): Promise<readonly string[]> {
  const { projects } = (await browser.get('/projects')).body as { projects: { name: string }[] }
  return projects.map(({ name }) => name)
}

async function namesOfVersions({ browser }: Pupil, id: string): Promise<readonly string[]> {
  const path = `/projects/project-${id}/versions`
  const answer = await browser.get(path)
  if (answer.status !== 200) return []
  const { versions } = answer.body as { versions: { revision: number }[] }
  const all = versions.map(({ revision }) => browser.get(`${path}/${revision}`))
  return (await Promise.all(all)).map(({ body }) => (body as { project: { name: string } }).project.name)
}

const id = fc.constantFrom('fear', 'friendship')
const which = fc.constantFrom(0, 1)
const fates: readonly Fate[] = ['arrives', 'isLost', 'answerIsLost', 'comesTwice', 'late']
const step = fc.oneof(
  { weight: 4, arbitrary: fc.record({ kind: fc.constant('edit'), device: which, id }) },
  {
    weight: 4,
    arbitrary: fc.record({ kind: fc.constant('send'), device: which, fate: fc.constantFrom(...fates) }),
  },
  { weight: 1, arbitrary: fc.record({ kind: fc.constant('crash'), device: which }) },
  {
    weight: 1,
    arbitrary: fc.record({ kind: fc.constant('fetch'), device: which, fate: fc.constantFrom(...fates) }),
  },
  { weight: 1, arbitrary: fc.record({ kind: fc.constant('choose'), device: which, own: fc.boolean() }) },
  { weight: 1, arbitrary: fc.record({ kind: fc.constant('late'), device: which }) },
  { weight: 1, arbitrary: fc.record({ kind: fc.constant('throw'), device: which, id }) },
  { weight: 1, arbitrary: fc.record({ kind: fc.constant('sendAll'), device: which }) },
  // On one of them only: restored on both, the same work is there twice.
  { weight: 1, arbitrary: fc.record({ kind: fc.constant('back'), device: fc.constant(0) }) },
) as fc.Arbitrary<{
  kind: 'edit' | 'send' | 'crash' | 'fetch' | 'choose' | 'late' | 'throw' | 'sendAll' | 'back'
  device: 0 | 1
  id?: string
  fate?: Fate
  own?: boolean
}>

test(
  'two devices edit, throw away, lose the network, crash and send twice: nothing is lost, nothing is doubled',
  { timeout: isLong ? 900_000 : 60_000 },
  async () => {
    const devices = [await newDevice(), await newDevice()] as const
    await fc.assert(
      fc.asyncProperty(fc.array(step, { maxLength: 25 }), fc.boolean(), async (steps, own) => {
        const pupil = await newPupil()
        const cable = new Cable(pupil)
        const work = new Work()
        for (const device of devices) await device.clear()
        for (const { kind, device, id: on = 'fear', fate = 'arrives', own: keepsOwn = true } of steps) {
          const on1 = devices[device]
          cable.fate = fate
          if (kind === 'edit') await work.edit(on1, on)
          else if (kind === 'send') await on1.page.sendNext(cable.ask)
          else if (kind === 'crash') await on1.crash()
          else if (kind === 'fetch') await on1.page.fetchWork(cable.ask)
          else if (kind === 'throw') await on1.page.throwAway(on)
          else if (kind === 'sendAll') await on1.page.sendAll(cable.ask)
          else if (kind === 'back') await takeOneBack(on1)
          else if (kind === 'choose') await choose(on1, cable, keepsOwn)
          else await cable.deliverLate()
        }
        await settle(devices, cable, own)
        const heads = await headsIn(pupil)
        expect(work.lostWith([...heads, ...(await inBins(devices))])).toEqual([])
        expect(new Set(heads).size).toBe(heads.length)
        for (const one of ['fear', 'friendship']) {
          const names = await namesOfVersions(pupil, one)
          expect(new Set(names).size).toBe(names.length)
        }
      }),
      {
        numRuns: isLong ? 1500 : 40,
        examples: [
          [
            [
              { kind: 'edit', device: 0, id: 'friendship' },
              { kind: 'send', device: 0, fate: 'arrives' },
              { kind: 'throw', device: 0, id: 'friendship' },
              { kind: 'back', device: 0 },
            ],
            false,
          ],
        ],
      },
    )
  },
)

test('a child unplugs with three unsent saves, another signs in and plugs in: nothing is mixed, nothing lost', async () => {
  const laptop = await newDevice()
  const tablet = await newDevice()
  const [fox, owl] = [await newPupil(), await newPupil()]
  const work = new Work()
  for (let edits = 0; edits < 3; edits++) await work.edit(laptop, 'fear')
  // The owl's session answers now, and the fox's page is still open.
  const wrong = new Cable(owl, fox.id)
  expect(await laptop.page.sendAll(wrong.ask)).toBe('otherPupil')
  expect(await headsIn(owl)).toEqual([])
  // The fox works on another device meanwhile, and comes back.
  const cable = new Cable(fox)
  await work.edit(tablet, 'fear')
  expect(await tablet.page.sendAll(cable.ask)).toBeNull()
  await settle([laptop, tablet], cable, true)
  expect(work.lostWith(await headsIn(fox))).toEqual([])
  expect(await headsIn(owl)).toEqual([])
})

test('what is thrown away is thrown away in the class and on the other device, and comes back from the bin', async () => {
  const [laptop, tablet] = [await newDevice(), await newDevice()]
  const pupil = await newPupil()
  const cable = new Cable(pupil)
  await new Work().edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  expect(await tablet.page.load('fear')).not.toBeNull()
  cable.fate = 'isLost'
  await laptop.page.throwAway('fear')
  expect(await laptop.page.sendAll(cable.ask)).toBe('away')
  cable.fate = 'arrives'
  // The class has it still, and it stays away from here all the same.
  await laptop.page.fetchWork(cable.ask)
  expect(await laptop.page.load('fear')).toBeNull()
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual([])
  expect(await tablet.page.load('fear')).toBeNull()
  expect(await inBins([tablet])).toEqual(['work 1'])
  await takeOneBack(laptop)
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual(['work 1'])
  expect((await tablet.page.load('fear'))?.project.name).toBe('work 1')
})

test('work that another device has done since is not thrown away with what was before it', async () => {
  const [laptop, tablet] = [await newDevice(), await newDevice()]
  const pupil = await newPupil()
  const cable = new Cable(pupil)
  const work = new Work()
  await work.edit(laptop, 'fear')
  await settle([laptop, tablet], cable, true)
  await work.edit(tablet, 'fear')
  expect(await tablet.page.sendAll(cable.ask)).toBeNull()
  await laptop.page.throwAway('fear')
  await settle([laptop, tablet], cable, true)
  expect(await headsIn(pupil)).toEqual(['work 2'])
  expect((await laptop.page.load('fear'))?.project.name).toBe('work 2')
})

test('what the class does not take stays on the device, and the next change is sent again', async () => {
  const device = await newDevice()
  const pupil = await newPupil()
  const { ask } = new Cable(pupil)
  const work = new Work()
  await work.edit(device, 'fear')
  let refuses = true
  const picky: Ask = (method, path, body) =>
    refuses && method === 'PUT'
      ? Promise.resolve({ kind: 'refused', status: 413, code: 'tooBig', facts: {} })
      : ask(method, path, body)
  expect(await device.page.sendAll(picky)).toBeNull()
  expect((await device.page.whereabouts()).get('fear')).toEqual({ kind: 'refused', reason: 'tooBig' })
  refuses = false
  expect(await device.page.sendNext(picky)).toBe('none')
  await work.edit(device, 'fear')
  expect(await device.page.sendAll(picky)).toBeNull()
  expect(await headsIn(pupil)).toEqual(['work 2'])
})

test.each([
  ['full', 507, 'classFull'],
  ['trouble', 507, 'diskFull'],
  ['trouble', 503, 'busy'],
  ['trouble', 500, 'ourFault'],
  ['signedOut', 401, 'join'],
  ['ended', 410, 'classEnded'],
] as const)(
  'a class that answers %s (%i %s) gets the save later, under the same name',
  async (pause, status, code) => {
    const device = await newDevice()
    const pupil = await newPupil()
    const { ask } = new Cable(pupil)
    await new Work().edit(device, 'fear')
    const paths: string[] = []
    const seen =
      (next: Ask): Ask =>
      (method, path, body) => {
        paths.push(path)
        return next(method, path, body)
      }
    const refused: Ask = () => Promise.resolve({ kind: 'refused', status, code, facts: {} })
    expect(await device.page.sendAll(seen(refused))).toBe(pause)
    expect((await device.page.whereabouts()).get('fear')).toEqual({ kind: 'waiting' })
    expect(await device.page.sendAll(seen(ask))).toBeNull()
    expect(paths[1]).toBe(paths[0])
  },
)
