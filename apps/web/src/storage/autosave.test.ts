import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import type { Project } from '@botgarten/programs'
import { AGAIN, Autosave, LONGEST, PAUSE, type SaveStatus } from './autosave.ts'
import { throwAway } from './bin.ts'
import { load, rename, save } from './projects.ts'
import { deviceThatKeepsNothing, fillDisk, freshDevice, openTab, until } from './testing/device.ts'
import { friendship, tooMuch } from './testing/sample.ts'

// The storage is a real one; only the clock is not.
const open: { close(): void }[] = []
beforeEach(async () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'Date'] })
  await freshDevice()
})
afterEach(() => {
  for (const one of open.splice(0)) one.close()
  vi.useRealTimers()
})

const named = (name: string): Project => ({ ...friendship, name })
/** A project in a hand, and every status that the screen has seen. */
function begin(id = 'friendship', revision = 0, Tab = Autosave) {
  const seen: SaveStatus[] = []
  const autosave = new Tab(id, revision, (status) => seen.push(status))
  open.push(autosave)
  const changes = (name: string) => autosave.changed(() => named(name))
  const is = (state: SaveStatus['state']) => until(() => autosave.status.state === state)
  const states = () => seen.map(({ state }) => state).filter((state, at, all) => state !== all[at - 1])
  return { autosave, seen, states, changes, is }
}
const nameIn = async (id = 'friendship') => (await load(id))?.project.name ?? null
/** Long enough for whatever the storage does without a clock. */
const settle = async () => {
  for (let turns = 0; turns < 30; turns += 1) await new Promise((done) => setImmediate(done))
}

describe('saving by itself', () => {
  test('begins when a pause is over, and not before', async () => {
    const { changes, is, states } = begin()
    changes('one')
    vi.advanceTimersByTime(PAUSE - 1)
    await settle()
    expect(await nameIn()).toBeNull()
    expect(states()).toEqual(['saving'])
    vi.advanceTimersByTime(1)
    await is('saved')
    expect(await nameIn()).toBe('one')
    expect(states()).toEqual(['saving', 'saved'])
  })

  test('keeps what is asked for when it saves, not what was there when it changed', async () => {
    const { autosave, is } = begin()
    let name = 'early'
    autosave.changed(() => named(name))
    name = 'late'
    vi.advanceTimersByTime(PAUSE)
    await is('saved')
    expect(await nameIn()).toBe('late')
  })

  test('never leaves more than a second unsaved while a hand goes on', async () => {
    const { changes } = begin()
    const made: { at: number; saved: number }[] = []
    let now = 0
    for (let step = 0; step < 60; step += 1) {
      changes(String(step))
      made.push({ at: now, saved: Infinity })
      vi.advanceTimersByTime(50)
      now += 50
      await settle()
      const saved = Number((await nameIn()) ?? -1)
      for (const one of made.slice(0, saved + 1)) one.saved = Math.min(one.saved, now)
    }
    // The last ones still wait: the hand has not stopped.
    const waited = made.filter(({ at }) => at <= now - 1000).map(({ at, saved }) => saved - at)
    expect(waited.length).toBe(41)
    expect(Math.max(...waited)).toBeLessThanOrEqual(LONGEST + 50)
    expect(LONGEST + PAUSE).toBeLessThan(1000)
  })

  test('has no second save where nothing changes any more', async () => {
    const { changes, is } = begin()
    changes('one')
    vi.advanceTimersByTime(PAUSE)
    await is('saved')
    const { revision } = (await load('friendship'))!
    vi.advanceTimersByTime(60_000)
    await settle()
    expect((await load('friendship'))!.revision).toBe(revision)
  })

  test('has a new limit after each save', async () => {
    const { changes, is } = begin()
    changes('one')
    vi.advanceTimersByTime(PAUSE)
    await is('saved')
    vi.advanceTimersByTime(LONGEST)
    changes('two')
    vi.advanceTimersByTime(PAUSE - 1)
    await settle()
    expect(await nameIn()).toBe('one')
    for (let step = 0; step < 4; step += 1) {
      changes('three')
      vi.advanceTimersByTime(100)
    }
    await until(() => false).catch(() => {})
    expect(await nameIn()).toBe('three')
  })

  test('what changes while it saves is saved after it', async () => {
    const { autosave, changes, is, states } = begin()
    changes('one')
    void autosave.flush()
    await Promise.resolve()
    changes('two')
    await until(() => autosave.status.state === 'saving')
    await settle()
    expect([await nameIn(), autosave.status.state]).toEqual(['one', 'saving'])
    vi.advanceTimersByTime(PAUSE)
    await is('saved')
    expect(await nameIn()).toBe('two')
    expect(states()).toEqual(['saving', 'saved'])
  })

  test('at once where a page is left, and once more where nothing waits changes nothing', async () => {
    const { autosave, changes } = begin()
    changes('one')
    await autosave.flush()
    expect(await nameIn()).toBe('one')
    const before = await load('friendship')
    await autosave.flush()
    expect(await load('friendship')).toEqual(before)
  })

  test('goes on from the revision that it was opened with', async () => {
    await save('friendship', named('before'), 0)
    const { revision } = (await load('friendship'))!
    const { autosave, changes } = begin('friendship', revision)
    const given = { id: 'friendship', state: 'saved', storage: 'ok', refusal: null }
    expect(autosave.status).toEqual({ ...given, revision })
    changes('after')
    await autosave.flush()
    expect(autosave.status).toEqual({ ...given, revision: revision + 1 })
    expect(await load('friendship')).toMatchObject({ revision: revision + 1, project: { name: 'after' } })
  })

  test('the last change is saved when the page is closed', async () => {
    const { autosave, changes } = begin()
    changes('last')
    autosave.close()
    await settle()
    expect(await nameIn()).toBe('last')
  })
})

describe('a save that fails', () => {
  test('on a full disk says so, is tried again by itself, and again until there is room', async () => {
    const { autosave, changes, is } = begin()
    const makeRoom = fillDisk()
    changes('one')
    vi.advanceTimersByTime(PAUSE)
    await is('failed')
    expect(autosave.status.storage).toBe('full')
    vi.advanceTimersByTime(AGAIN)
    await settle()
    expect([autosave.status.state, await nameIn()]).toEqual(['failed', null])
    makeRoom()
    vi.advanceTimersByTime(AGAIN - 1)
    await settle()
    expect(await nameIn()).toBeNull()
    vi.advanceTimersByTime(1)
    await is('saved')
    expect([autosave.status.storage, await nameIn()]).toEqual(['ok', 'one'])
  })

  test('is tried again by a press, and a change does so too', async () => {
    const { autosave, changes, is, states } = begin()
    let makeRoom = fillDisk()
    changes('one')
    await autosave.flush()
    makeRoom()
    autosave.retry()
    expect(autosave.status.state).toBe('saving')
    await is('saved')
    expect(await nameIn()).toBe('one')
    makeRoom = fillDisk()
    changes('two')
    await autosave.flush()
    expect(autosave.status.state).toBe('failed')
    makeRoom()
    changes('three')
    vi.advanceTimersByTime(PAUSE)
    await is('saved')
    expect(await nameIn()).toBe('three')
    expect(states()).toEqual(['saving', 'failed', 'saving', 'saved', 'saving', 'failed', 'saving', 'saved'])
  })

  test('keeps the newest, not what failed', async () => {
    const { autosave, changes } = begin()
    const makeRoom = fillDisk()
    changes('old')
    const failing = autosave.flush()
    changes('new')
    await failing
    makeRoom()
    await autosave.flush()
    expect(await nameIn()).toBe('new')
  })

  test('in a private window says that nothing is kept', async () => {
    await deviceThatKeepsNothing()
    const { autosave, changes } = begin()
    changes('one')
    await autosave.flush()
    expect(autosave.status).toMatchObject({ state: 'failed', storage: 'refused' })
  })

  test('by a fault of ours is told as one, and the next is saved', async () => {
    vi.spyOn(console, 'error').mockImplementation(() => {})
    const { autosave, changes } = begin()
    autosave.changed(() => {
      throw new RangeError('A fault.')
    })
    await autosave.flush()
    expect(autosave.status).toMatchObject({ state: 'failed', storage: 'refused' })
    changes('one')
    await autosave.flush()
    expect([autosave.status.state, await nameIn()]).toEqual(['saved', 'one'])
  })

  test('is not tried again on a page that is closed', async () => {
    const { autosave, changes } = begin()
    const makeRoom = fillDisk()
    changes('one')
    autosave.close()
    await settle()
    makeRoom()
    vi.advanceTimersByTime(10 * AGAIN)
    await settle()
    expect(await nameIn()).toBeNull()
  })
})

describe('a project that is too much', () => {
  test('is not saved; what was saved stays, and it is said what is too much', async () => {
    const { autosave, changes, is } = begin()
    changes('good')
    await autosave.flush()
    autosave.changed(() => tooMuch)
    vi.advanceTimersByTime(PAUSE)
    await is('failed')
    expect(autosave.status.storage).toBe('tooMuch')
    expect(autosave.status.refusal?.limit).toEqual({ kind: 'text', most: 20_000 })
    expect(await nameIn()).toBe('good')
    vi.advanceTimersByTime(10 * AGAIN)
    await settle()
    expect(autosave.status.state).toBe('failed')
    changes('small again')
    vi.advanceTimersByTime(PAUSE)
    await is('saved')
    expect(autosave.status).toMatchObject({ storage: 'ok', refusal: null })
    expect(await nameIn()).toBe('small again')
  })

  test('and a full disk are told apart', async () => {
    const { autosave, changes } = begin()
    autosave.changed(() => tooMuch)
    await autosave.flush()
    fillDisk()
    changes('small')
    await autosave.flush()
    expect(autosave.status).toMatchObject({ storage: 'full', refusal: null })
  })
})

describe('two tabs', () => {
  /** Another page of this browser. */
  async function otherTab(id = 'friendship') {
    const tab = await openTab()
    const found = await tab.load(id)
    return { ...tab, ...begin(id, found?.revision ?? 0, tab.Autosave) }
  }

  test('a tab hears at once that another one has saved, and saves nothing over it', async () => {
    const first = begin()
    first.changes('one')
    await first.autosave.flush()
    const second = await otherTab()
    first.changes('two')
    await first.autosave.flush()
    await second.is('elsewhere')
    second.changes('three')
    expect(second.autosave.status.state).toBe('elsewhere')
    vi.advanceTimersByTime(60_000)
    await settle()
    expect(await nameIn()).toBe('two')
    await second.autosave.flush()
    expect([second.autosave.status.state, await nameIn()]).toEqual(['elsewhere', 'two'])
    expect(first.autosave.status.state).toBe('saved')
  })

  test('a tab that did not hear is told by its next save', async () => {
    const { autosave, changes } = begin()
    changes('one')
    await autosave.flush()
    const { revision } = (await load('friendship'))!
    // Without a word in the channel.
    const { database } = await import('./database.ts')
    await (await database()).put('revisions', { id: 'friendship', revision: revision + 1 })
    changes('two')
    await autosave.flush()
    expect([autosave.status.state, await nameIn()]).toEqual(['elsewhere', 'one'])
  })

  test('two that begin the same card at once: the first has it, the second is told', async () => {
    const [first, second] = [begin(), await otherTab()]
    first.changes('first')
    second.changes('second')
    await Promise.all([first.autosave.flush(), second.autosave.flush()])
    await settle()
    const states = [first.autosave.status.state, second.autosave.status.state].toSorted()
    expect(states).toEqual(['elsewhere', 'saved'])
  })

  test('mine goes on as a copy; both are there, and each is saved under its own key', async () => {
    const first = begin()
    first.changes('one')
    await first.autosave.flush()
    const second = await otherTab()
    first.changes('two')
    await first.autosave.flush()
    await second.is('elsewhere')
    await second.autosave.continueAs('friendship-copy', () => named('mine'))
    expect(second.autosave.status).toMatchObject({ id: 'friendship-copy', state: 'saved' })
    second.changes('mine, later')
    await second.autosave.flush()
    expect([await nameIn(), await nameIn('friendship-copy')]).toEqual(['two', 'mine, later'])
    // What is saved under the old key is nothing to it any more.
    first.changes('four')
    await first.autosave.flush()
    await settle()
    expect(second.autosave.status.state).toBe('saved')
  })

  test('the copy is called saved when it is, and hears what other tabs do with it', async () => {
    const { autosave, changes, seen, is } = begin()
    changes('one')
    await autosave.flush()
    const before = seen.length
    await autosave.continueAs('friendship-copy', () => named('copy'))
    expect(seen.slice(before).map(({ id, state }) => [id, state])).toEqual([
      ['friendship-copy', 'saving'],
      ['friendship-copy', 'saved'],
    ])
    const tab = await openTab()
    const { revision } = (await tab.load('friendship-copy'))!
    await tab.save('friendship-copy', named('theirs'), revision)
    await is('elsewhere')
    changes('mine')
    await autosave.flush()
    expect(await nameIn('friendship-copy')).toBe('theirs')
  })

  test('a save that is on its way does not disturb the copy', async () => {
    const { autosave, changes } = begin()
    changes('one')
    void autosave.flush()
    await Promise.resolve()
    changes('two')
    const flushed = autosave.continueAs('friendship-copy', () => named('copy'))
    await flushed
    expect(autosave.status).toMatchObject({ id: 'friendship-copy', state: 'saved' })
    changes('copy, later')
    await autosave.flush()
    expect([autosave.status.state, await nameIn('friendship-copy')]).toEqual(['saved', 'copy, later'])
    expect(await nameIn()).toBe('one')
  })

  test('mine is put aside under a name of its own before the newer one is shown', async () => {
    const first = begin()
    first.changes('one')
    await first.autosave.flush()
    const second = await otherTab()
    first.changes('two')
    await first.autosave.flush()
    await second.is('elsewhere')
    second.changes('mine')
    expect(await second.autosave.putAside('friendship-aside', 'one (copy)')).toBe(true)
    expect(await nameIn('friendship-aside')).toBe('one (copy)')
    // Once is enough.
    expect(await second.autosave.putAside('friendship-again', 'x')).toBe(true)
    expect(await nameIn('friendship-again')).toBeNull()
  })

  test('where it cannot be put aside it is not lost', async () => {
    const { autosave, changes } = begin()
    changes('mine')
    const makeRoom = fillDisk()
    expect(await autosave.putAside('aside', 'x')).toBe(false)
    makeRoom()
    await autosave.flush()
    expect(await nameIn()).toBe('mine')
  })

  test('a name that another tab gives is taken over, and both go on', async () => {
    const { autosave, changes } = begin()
    changes('one')
    await autosave.flush()
    const names: string[] = []
    autosave.whenRenamed = (name) => names.push(name)
    const other = await otherTab()
    await other.rename('friendship', 'new name')
    await until(() => names.length > 0)
    expect([names, autosave.status.state]).toEqual([['new name'], 'saved'])
    changes('after')
    await autosave.flush()
    expect([autosave.status.state, await nameIn()]).toEqual(['saved', 'after'])
  })

  test('a name that comes with more than a name is news', async () => {
    const { autosave, changes } = begin()
    changes('one')
    await autosave.flush()
    const tab = await openTab()
    const { revision } = (await tab.load('friendship'))!
    // This tab does not hear of the first of two changes.
    const { database } = await import('./database.ts')
    await (await database()).put('revisions', { id: 'friendship', revision: revision + 1 })
    await tab.rename('friendship', 'new name')
    await until(() => autosave.status.state === 'elsewhere')
  })

  test('what another tab throws away is said; what was never saved cannot be', async () => {
    const { autosave, changes, is } = begin()
    const unsaved = begin('friendship')
    changes('one')
    await autosave.flush()
    const tab = await openTab()
    await tab.throwAway('friendship')
    await is('gone')
    await settle()
    expect(unsaved.autosave.status.state).not.toBe('gone')
    changes('two')
    await autosave.flush()
    expect([autosave.status.state, await nameIn()]).toEqual(['gone', null])
    await autosave.continueAs('friendship-again', () => named('two'))
    expect([autosave.status.state, await nameIn('friendship-again')]).toEqual(['saved', 'two'])
  })

  test('a tab that did not hear of the bin is told by its next save', async () => {
    const { autosave, changes } = begin()
    changes('one')
    await autosave.flush()
    // A channel does not hear itself.
    await throwAway('friendship')
    changes('two')
    await autosave.flush()
    expect(autosave.status.state).toBe('gone')
    expect(await nameIn()).toBeNull()
  })

  test('news of other projects, and older news, change nothing', async () => {
    const { autosave, changes } = begin()
    changes('one')
    await autosave.flush()
    const tab = await openTab()
    await tab.save('fear', named('other'), 0)
    await tab.rename('fear', 'x')
    await tab.throwAway('fear')
    await settle()
    expect(autosave.status.state).toBe('saved')
    autosave.close()
    await tab.rename('friendship', 'after closing')
    await settle()
    expect(autosave.status.state).toBe('saved')
  })

  test('rename tells a tab that is gone so', async () => {
    expect(await rename('nothing', 'x')).toEqual({ kind: 'gone' })
  })
})
