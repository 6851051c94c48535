// A class on a real database, and devices of its pupils: browsers' databases with pages of their own.
import 'fake-indexeddb/auto'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { migrate, openSqlite, type Database } from '@botgarten/classroom'
import { Server } from '@botgarten/classroom/testing'
import { IDBFactory } from 'fake-indexeddb'
import { afterAll, beforeAll, expect, vi } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { askAs, type Ask } from '#storage/ask.ts'

export type Pupil = Awaited<ReturnType<Server['pupil']>>

const folder = mkdtempSync(join(tmpdir(), 'botgarten-devices-'))
let database: Database
let server: Server
let teacher: Awaited<ReturnType<Server['firstTeacher']>>
let code: string
let nicknames = 0

beforeAll(async () => {
  database = openSqlite(join(folder, 'class.db'))
  await migrate(database)
  server = new Server(database)
  teacher = await server.firstTeacher()
})
afterAll(async () => {
  await database.close()
  rmSync(folder, { recursive: true, force: true })
})
/** A pupil who has just joined; fifty are in a class. */
export async function newPupil() {
  if (nicknames % 50 === 0) ({ code } = await server.openClass(teacher))
  return server.pupil(code, `Kind ${++nicknames}`)
}

/** The class of a pupil has ended by the date of the server, and is shown again later. @returns shows it again */
export async function hideClass({ class: id }: Pupil): Promise<() => Promise<void>> {
  const end = async (endsOn: string) =>
    void (await database.db.updateTable('class').set({ endsOn }).where('id', '=', id).execute())
  await end(server.ports.day(0))
  return () => end(server.ports.day(60))
}

/** The outcome of a request. `late`: it arrives much later, when the device has long given up. */
export type Fate = 'arrives' | 'isLost' | 'answerIsLost' | 'comesTwice' | 'late'

export class Cable {
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
export async function newDevice() {
  const factory = new IDBFactory()
  const pages = async () => {
    globalThis.indexedDB = factory
    vi.resetModules()
    const { sendAll, sendNext } = await import('../sending.ts')
    const [projects, outbox, arriving, bin, { database: opened }, { seenMark }] = await Promise.all([
      import('#storage/projects.ts'),
      import('#storage/outbox.ts'),
      import('../arriving.ts'),
      import('#storage/bin.ts'),
      import('#storage/database.ts'),
      import('#storage/class-versions.ts'),
    ])
    await opened()
    const member = () => import('../member.svelte.ts')
    return { ...projects, ...outbox, sendAll, sendNext, ...arriving, ...bin, opened, seenMark, member }
  }
  let page = await pages()
  return {
    get page() {
      return page
    },
    /** The browser is closed and opened again: only written records are left. */
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

/** Copies a pupil's rows in the class. @returns a function that restores them, as a backup of the database would */
export async function backUp({ id }: Pupil) {
  const { db } = database
  const rows = await Promise.all(
    ofPupil.map((table) => db.selectFrom(table).selectAll().where('pupil', '=', id).execute()),
  )
  const pupil = await db.selectFrom('pupil').select('changes').where('id', '=', id).executeTakeFirstOrThrow()
  return async () => {
    for (const table of ofPupil.toReversed()) await db.deleteFrom(table).where('pupil', '=', id).execute()
    for (const [at, table] of ofPupil.entries())
      if (rows[at]!.length > 0)
        await db
          .insertInto(table)
          .values(rows[at] as never)
          .execute()
    await db.updateTable('pupil').set(pupil).where('id', '=', id).execute()
  }
}
const ofPupil = ['project', 'thrown', 'mark', 'version', 'versionAsset', 'answered'] as const

export type Device = Awaited<ReturnType<typeof newDevice>>

const named = (name: string) => ({ ...friendship, name })

/** A child works with a project on a device, and every piece of work knows its predecessor. */
export class Work {
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

/** A pupil with a laptop and a tablet, the cable of both to the class, and the work on them. */
export async function scene() {
  const [laptop, tablet] = [await newDevice(), await newDevice()]
  const pupil = await newPupil()
  const cable = new Cable(pupil)
  return { laptop, tablet, pupil, cable, work: new Work() }
}

let copies = 0
const copyOf = (project: typeof friendship) => ({ id: `copy-${++copies}`, project, changed: 1 })

export async function choose({ page }: Device, cable: Cable, own: boolean) {
  for (const [id, place] of await page.whereabouts()) {
    if (place.kind !== 'conflict') continue
    const other = await page.fetchProject(cable.ask, id)
    if (!other) continue
    if (own) await page.goOnWithOwn(other, copyOf(other.project))
    else await page.goOnWithClass(other, copyOf)
  }
}

/** The cable is back: everything is sent, and asked until nothing is open. */
export async function settle(devices: readonly Device[], cable: Cable, own: boolean) {
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
export async function inBins(devices: readonly Device[]): Promise<readonly string[]> {
  const bins = await Promise.all(devices.map(({ page }) => page.listBin()))
  return bins.flatMap(({ thrown }) => thrown.map(({ project }) => project.name))
}

export async function takeOneBack({ page }: Device) {
  const [last] = (await page.listBin()).thrown
  if (last) await page.takeBack(last.id)
}

/** The names of a pupil's projects in the class. */
export async function headsIn({ id }: Pupil): Promise<readonly string[]> {
  const rows = await database.db.selectFrom('project').select('name').where('pupil', '=', id).execute()
  return rows.map(({ name }) => name)
}

export async function namesOfVersions({ browser }: Pupil, id: string): Promise<readonly string[]> {
  const path = `/projects/project-${id}/versions`
  const answer = await browser.get(path)
  if (answer.status !== 200) return []
  const { versions } = answer.body as { versions: { revision: number }[] }
  const all = versions.map(({ revision }) => browser.get(`${path}/${revision}`))
  return (await Promise.all(all)).map(({ body }) => (body as { project: { name: string } }).project.name)
}
