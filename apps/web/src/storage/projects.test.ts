import { beforeEach, describe, expect, test, vi } from 'vitest'
import { deleteDB, openDB } from 'idb'
import { throwAway } from './bin.ts'
import { database, keepsAnything } from './database.ts'
import { add, list, listWhole, load, loadPicture, open, rename, save } from './projects.ts'
import {
  deviceThatKeepsNothing,
  fillDisk,
  freshDevice,
  keysIn,
  openTab,
  putOldDevice,
  recordIn,
  until,
} from './testing/device.ts'
import { fear, friendship, hash, tooMuch, withPicture } from './testing/sample.ts'

beforeEach(freshDevice)

const other = 'b'.repeat(64)
const revisionNow = async (id = 'friendship') => (await load(id))!.revision
const puts = () => vi.spyOn(IDBObjectStore.prototype, 'put')

describe('a project', () => {
  test('that nobody has saved is not there', async () => {
    expect(await load('friendship')).toBeNull()
    expect(await open('friendship')).toBeNull()
    expect(await list()).toEqual({ projects: [], damaged: [] })
  })

  test('is there as it was saved, with its pictures', async () => {
    const before = Date.now()
    const saved = await save('friendship', withPicture(5000), 0)
    const kept = (await load('friendship'))!
    expect(saved).toEqual({ kind: 'saved', revision: kept.revision })
    expect(kept).toEqual({
      ...{ id: 'friendship', project: withPicture(5000) },
      ...{ changed: kept.changed, revision: kept.revision },
    })
    expect(kept.changed).toBeGreaterThanOrEqual(before)
    // A moment: a key that is used again after the bin never comes back to a revision of before.
    expect(kept.revision).toBeGreaterThanOrEqual(before)
    expect(await open('friendship')).toEqual(kept)
  })

  test('stands in the list without its pictures, which can be asked for', async () => {
    await save('friendship', withPicture(5000), 0)
    const { projects } = await list()
    expect(projects).toEqual([
      { id: 'friendship', project: { ...withPicture(5000), assets: {} }, changed: projects[0]!.changed },
    ])
    expect(await loadPicture('friendship', hash)).toEqual(withPicture(5000).assets[hash])
    expect(await loadPicture('friendship', other)).toBeUndefined()
    expect((await listWhole()).projects[0]!.project).toEqual(withPicture(5000))
  })

  test('has a higher revision after every save, and the list begins with what was changed last', async () => {
    vi.useFakeTimers({ toFake: ['Date'], now: 1000 })
    await save('friendship', friendship, 0)
    vi.setSystemTime(2000)
    await save('fear', fear, 0)
    const first = await revisionNow()
    vi.setSystemTime(3000)
    expect(await save('friendship', friendship, first)).toEqual({ kind: 'saved', revision: first + 1 })
    vi.useRealTimers()
    expect((await list()).projects.map(({ id, changed }) => [id, changed])).toEqual([
      ['friendship', 3000],
      ['fear', 2000],
    ])
  })

  test('is not saved over what another tab has saved or thrown away', async () => {
    await save('friendship', friendship, 0)
    const revision = await revisionNow()
    expect(await save('friendship', fear, 0)).toEqual({ kind: 'newer' })
    expect(await save('friendship', fear, revision - 1)).toEqual({ kind: 'newer' })
    expect(await save('friendship', fear, revision + 1)).toEqual({ kind: 'newer' })
    expect((await load('friendship'))!.project).toEqual(friendship)
    await throwAway('friendship')
    expect(await save('friendship', fear, revision)).toEqual({ kind: 'gone' })
    expect(await load('friendship')).toBeNull()
  })

  test('that is too much is not saved, whoever saves it, and what was there stays', async () => {
    await save('friendship', friendship, 0)
    const before = await load('friendship')
    expect(await save('friendship', tooMuch, before!.revision)).toMatchObject({ kind: 'tooMuch' })
    expect(await save('fear', withPicture(5_000_000), 0)).toMatchObject({
      ...{ kind: 'tooMuch', refusal: { limit: { kind: 'size' } } },
    })
    expect(await rename('friendship', 'n'.repeat(20_001))).toMatchObject({ kind: 'tooMuch' })
    expect(await load('friendship')).toEqual(before)
    expect(await keysIn('projects')).toEqual(['friendship'])
  })

  test('gets another name and keeps the rest', async () => {
    await save('friendship', withPicture(5000), 0)
    const before = (await load('friendship'))!
    expect(await rename('friendship', 'Mine')).toEqual({ kind: 'saved', revision: before.revision + 1 })
    expect(await load('friendship')).toEqual({
      ...{ ...before, revision: before.revision + 1 },
      project: { ...withPicture(5000), name: 'Mine' },
    })
  })
})

describe('a save', () => {
  test('writes a picture once, and neither reads nor writes it again', async () => {
    await save('friendship', withPicture(5000), 0)
    const put = puts()
    const get = vi.spyOn(IDBObjectStore.prototype, 'get')
    await save('friendship', { ...withPicture(5000), name: 'later' }, await revisionNow())
    const written = put.mock.calls.map(([value]) => JSON.stringify(value).length)
    expect(Math.max(...written)).toBeLessThan(5000)
    const stores = get.mock.contexts as readonly IDBObjectStore[]
    const pictures = stores.filter(({ name }) => name === 'pictures')
    expect(pictures).toEqual([])
    expect((await load('friendship'))!.project).toEqual({ ...withPicture(5000), name: 'later' })
  })

  test('takes away a picture that is in use no more, and no picture of another project', async () => {
    await save('friendship', withPicture(10), 0)
    await save('friendship2', withPicture(20), 0)
    await save('friendship', withPicture(30, friendship, other), await revisionNow())
    expect(await keysIn('pictures')).toEqual([
      ['friendship', other],
      ['friendship2', hash],
    ])
    await save('friendship', friendship, await revisionNow())
    expect(await keysIn('pictures')).toEqual([['friendship2', hash]])
  })

  test('tells other tabs', async () => {
    const tab = await openTab()
    const news: string[] = []
    const watching = new tab.Autosave('friendship', 0, ({ state }) => news.push(state))
    await save('friendship', friendship, 0)
    await until(() => news.length > 0)
    expect(news).toEqual(['elsewhere'])
    watching.close()
  })

  test('on a full disk leaves everything as it was', async () => {
    await save('friendship', withPicture(10), 0)
    const before = await load('friendship')
    const makeRoom = fillDisk()
    expect(await save('friendship', fear, before!.revision)).toEqual({ kind: 'full' })
    expect(await rename('friendship', 'x')).toEqual({ kind: 'full' })
    expect(await add([{ id: 'new', project: fear, changed: 1 }])).toBe('full')
    makeRoom()
    expect(await load('friendship')).toEqual(before)
    expect(await keysIn('projects')).toEqual(['friendship'])
  })

  test('that runs out of room at its last part leaves no half behind', async () => {
    await save('friendship', withPicture(10), 0)
    const before = await load('friendship')
    const put = Object.getOwnPropertyDescriptor(IDBObjectStore.prototype, 'put')!.value as (v: unknown) => IDBRequest // prettier-ignore
    vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function (this: IDBObjectStore, value) {
      if (this.name === 'pictures') throw new DOMException('Full.', 'QuotaExceededError')
      return put.call(this, value) as IDBRequest<IDBValidKey>
    })
    const saved = await save('friendship', withPicture(20, fear, other), before!.revision)
    expect(saved).toEqual({ kind: 'full' })
    vi.restoreAllMocks()
    expect(await load('friendship')).toEqual(before)
  })

  test('in a browser that keeps nothing says so', async () => {
    await deviceThatKeepsNothing()
    expect(await save('friendship', friendship, 0)).toEqual({ kind: 'refused' })
    expect(await load('friendship')).toBeNull()
    expect(await loadPicture('friendship', hash)).toBeUndefined()
    expect(await list()).toEqual({ projects: [], damaged: [] })
    expect(await add([])).toBe('refused')
    expect(await keepsAnything()).toBe(false)
    vi.restoreAllMocks()
    // What is refused once may be allowed the next time.
    expect(await keepsAnything()).toBe(true)
    expect(await save('friendship', friendship, 0)).toMatchObject({ kind: 'saved' })
  })
})

describe('projects that come together', () => {
  const one = (id: string) => ({ id, project: withPicture(10), changed: 7 })

  test('are all there, with when they were changed', async () => {
    expect(await add([one('a'), one('b')])).toBeNull()
    expect(await listWhole()).toEqual({ projects: [one('a'), one('b')], damaged: [] })
    expect(await save('a', friendship, await revisionNow('a'))).toMatchObject({ kind: 'saved' })
  })

  test('are all not there where one of their keys is taken', async () => {
    await save('b', fear, 0)
    expect(await add([one('a'), one('b'), one('c')])).toBe('refused')
    expect(await keysIn('projects')).toEqual(['b'])
    expect((await load('b'))!.project).toEqual(fear)
  })
})

describe('a record of the version before', () => {
  const record = { id: 'friendship', project: withPicture(5000), changed: 12, revision: 34 }

  test('is read as it is, and its pictures and its revision get records of their own when it is opened', async () => {
    await putOldDevice([record])
    expect((await list()).projects).toEqual([{ id: 'friendship', project: record.project, changed: 12 }])
    expect(await keysIn('pictures')).toEqual([])
    expect(await load('friendship')).toEqual(record)
    expect(await keysIn('pictures')).toEqual([['friendship', hash]])
    expect(await recordIn('revisions', 'friendship')).toEqual({ id: 'friendship', revision: 34 })
    expect(await recordIn('projects', 'friendship')).toEqual({
      ...{ id: 'friendship', changed: 12, pictures: [hash] },
      project: { ...record.project, assets: {} },
    })
    expect(await load('friendship')).toEqual(record)
    expect((await listWhole()).projects).toEqual([{ id: 'friendship', project: record.project, changed: 12 }])
  })

  test('is split once', async () => {
    await putOldDevice([record])
    await load('friendship')
    const put = puts()
    await load('friendship')
    expect(put).not.toHaveBeenCalled()
  })

  test('is saved over by a tab that has opened it, and by no other', async () => {
    await putOldDevice([record])
    expect(await save('friendship', fear, 33)).toEqual({ kind: 'newer' })
    expect(await save('friendship', fear, 34)).toEqual({ kind: 'saved', revision: 35 })
    expect(await load('friendship')).toMatchObject({ project: fear, revision: 35 })
    expect(await keysIn('pictures')).toEqual([])
  })

  test('gets a name, goes into the bin, and goes home', async () => {
    await putOldDevice([record, { ...record, id: 'fear' }])
    expect(await rename('friendship', 'Mine')).toEqual({ kind: 'saved', revision: 35 })
    expect((await load('friendship'))!.project).toEqual({ ...record.project, name: 'Mine' })
    expect((await listWhole()).projects.find(({ id }) => id === 'fear')!.project).toEqual(record.project)
    expect(await throwAway('fear')).toMatchObject({ kind: 'moved' })
    expect(await load('fear')).toBeNull()
  })

  test('stays as it is, and is shown, where there is no room to split it', async () => {
    await putOldDevice([record])
    await database()
    const makeRoom = fillDisk()
    expect(await load('friendship')).toEqual(record)
    makeRoom()
    expect(await recordIn('projects', 'friendship')).toEqual(record)
  })

  test('on a device that goes from the very first version too', async () => {
    const db = await openDB('botgarten', 1, {
      upgrade: (made) => void made.createObjectStore('projects', { keyPath: 'id' }),
    })
    await db.put('projects', record)
    db.close()
    expect(await load('friendship')).toEqual(record)
  })
})

describe('tabs of several versions', () => {
  /** A tab with a database of some version. `stubborn`: it does not let go when it is asked to. */
  const tabOf = async (version: number, stubborn = false) => {
    const db = await openDB('botgarten', version, {
      blocking: (_now, _wanted, event) => void (stubborn || (event.target as IDBDatabase).close()),
      upgrade: (made) => {
        for (const store of ['projects', 'bin'])
          if (!made.objectStoreNames.contains(store)) made.createObjectStore(store, { keyPath: 'id' })
      },
    })
    return db
  }

  test('an older tab that is open lets go, and what it has saved is there', async () => {
    const old = await tabOf(2)
    await old.put('projects', { id: 'friendship', project: friendship, changed: 1, revision: 2 })
    expect((await load('friendship'))?.project).toEqual(friendship)
    // Its next save is refused, which it tells its child; nothing is written in the old way.
    await expect(openDB('botgarten', 2)).rejects.toThrow()
  })

  test('a tab that does not let go is said to be in the way, and nothing is waited for without end', async () => {
    const old = await tabOf(2, true)
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
    const saving = save('friendship', friendship, 0)
    for (let turns = 0; turns < 20; turns += 1) await new Promise((done) => setImmediate(done))
    vi.advanceTimersByTime(3000)
    expect(await saving).toEqual({ kind: 'blocked' })
    vi.useRealTimers()
    old.close()
    expect(await save('friendship', friendship, 0)).toMatchObject({ kind: 'saved' })
  })

  test('this tab lets a newer one go ahead, and says from then on that it is to be loaded again', async () => {
    await save('friendship', friendship, 0)
    const newer = await tabOf(99)
    expect(await save('friendship', fear, 1)).toEqual({ kind: 'outdated' })
    newer.close()
  })

  test('a database that is cleared while the page is open is made again', async () => {
    await save('friendship', friendship, 0)
    await deleteDB('botgarten')
    expect(await load('friendship')).toBeNull()
    expect(await save('friendship', friendship, 0)).toMatchObject({ kind: 'saved' })
  })
})
