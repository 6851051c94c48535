import 'fake-indexeddb/auto'
import { writeProject } from '@botgarten/programs'
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'
import { listBin } from '#storage/bin.ts'
import type { Merged } from '#storage/files.ts'
import { load, save } from '#storage/projects.ts'
import { deviceThatKeepsNothing, fillDisk, freshDevice, openTab, putDevice } from '#storage/testing/device.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { fear, friendship } from '#storage/testing/sample.ts'
import { fetchWords, m } from '#words/message.ts'
import { ProjectList } from './project-list.svelte.ts'

beforeAll(() => fetchWords('projects'))
let projects: ProjectList
beforeEach(async () => {
  await freshDevice()
  freshLocalStorage()
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  projects = new ProjectList()
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

async function withProjects(...ids: readonly string[]) {
  for (const id of ids) await save(id, { ...friendship, name: id }, 0)
  await projects.look()
  return projects.all!
}
const names = () => projects.all!.map(({ project }) => project.name).sort()

describe('the list', () => {
  test('is unknown until it was read, then has all projects of the device', async () => {
    expect([projects.all, projects.keeps]).toEqual([null, true])
    await withProjects('one', 'two')
    expect([names(), projects.binned, projects.keeps]).toEqual([['one', 'two'], 0, true])
  })

  test('says where the browser saves nothing', async () => {
    await deviceThatKeepsNothing()
    await projects.look()
    expect(projects.keeps).toBe(false)
  })

  test('follows other tabs while it is watched', async () => {
    const stop = projects.watch()
    await vi.waitFor(() => expect(projects.all).toEqual([]))
    const tab = await openTab()
    await tab.save('one', friendship, 0)
    await vi.waitFor(() => expect(projects.all).toHaveLength(1))
    expect(projects.isOpenElsewhere('one')).toBe(false)
    stop()
  })
})

describe('a project', () => {
  test('gets another name, and a message shows it until it is closed', async () => {
    const [one] = await withProjects('one')
    await projects.rename(one!, 'eins')
    expect([names(), projects.said!.text]).toEqual([['eins'], m['projects.renamed']({ name: 'eins' })])
    projects.hush()
    expect([projects.said, projects.told]).toEqual([null, null])
  })

  test('is doubled under a name of its own', async () => {
    const [one] = await withProjects('one')
    await projects.duplicate(one!)
    const copy = projects.all!.find(({ id }) => id !== 'one')!
    expect([names().length, new Set(names()).size]).toEqual([2, 2])
    expect(projects.said!.text).toBe(m['projects.doubled']({ name: copy.project.name }))
    expect((await load(copy.id))!.project).toEqual({ ...friendship, name: copy.project.name })
  })

  test('goes to the bin, and comes back', async () => {
    const [one] = await withProjects('one')
    await projects.throwAway(one!)
    expect([names(), projects.binned, projects.said!.text]).toEqual([
      [],
      1,
      m['projects.thrown']({ name: 'one' }),
    ])
    await projects.said!.takeBack!()
    expect([names(), projects.binned, projects.said!.text]).toEqual([
      ['one'],
      0,
      m['projects.back']({ name: 'one' }),
    ])
    expect((await listBin()).thrown).toEqual([])
  })

  test('that another tab has deleted gets the message that it is gone', async () => {
    const [one] = await withProjects('one')
    await projects.throwAway(one!)
    await projects.rename(one!, 'eins')
    expect(projects.said!.text).toBe(m['projects.gone']())
  })

  test('for which there is no room is told in a dialog', async () => {
    const [one] = await withProjects('one')
    const makeRoom = fillDisk()
    await projects.duplicate(one!)
    makeRoom()
    expect([projects.told!.good, projects.said, names()]).toEqual([false, null, ['one']])
  })

  test('that cannot be read is listed apart, and can go to the bin', async () => {
    const damaged = { id: 'x', project: { name: 'x' }, changed: 1, revision: 1 }
    await putDevice({ name: 'botgarten', version: 2, stores: { projects: [damaged], bin: [] } } as never)
    await projects.look()
    const [one] = projects.damaged
    expect([projects.all, one!.id]).toEqual([[], 'x'])
    const files: Blob[] = []
    const link = { click: () => {}, remove: () => {}, href: '', download: '' }
    vi.stubGlobal('document', { createElement: () => link, body: { append: () => {} } })
    vi.spyOn(URL, 'createObjectURL').mockImplementation((file) => `blob:${files.push(file as Blob)}`)
    await projects.saveDamaged(one!)
    expect(JSON.parse(await files[0]!.text())).toMatchObject({ name: 'x' })
    await projects.throwDamaged(one!)
    expect([projects.damaged, projects.binned]).toEqual([[], 1])
  })
})

describe('a file', () => {
  const fileOf = (text: string) => new File([text], 'one.botgarten.json')

  test('with a project opens it', async () => {
    const opened = await projects.openFile(fileOf(writeProject(friendship)))
    expect(opened!.project).toEqual(friendship)
    expect(projects.told).toBeNull()
  })

  test('that is no project file is refused with a message', async () => {
    expect(await projects.openFile(fileOf('{}'))).toBeNull()
    expect([projects.told!.good, projects.all]).toEqual([false, []])
  })

  test('with everything of a device is imported, with a message of the counts', async () => {
    await withProjects('one')
    await save('two', { ...fear, name: 'two' }, 0)
    const { homeFiles } = await import('#storage/files.ts')
    const files: Blob[] = []
    const link = { click: () => {}, remove: () => {}, href: '', download: '' }
    vi.stubGlobal('document', { createElement: () => link, body: { append: () => {} } })
    vi.spyOn(URL, 'createObjectURL').mockImplementation((file) => `blob:${files.push(file as Blob)}`)
    expect(await homeFiles()).toHaveLength(1)
    await projects.takeHome()
    const text = await files[0]!.text()
    await freshDevice()
    vi.spyOn(console, 'warn').mockImplementation(() => {})
    const tells = vi.spyOn(projects, 'tellMerged')
    const shown: string[][] = []
    tells.mockImplementationOnce((merged) => {
      shown.push(names())
      tells.mockRestore()
      projects.tellMerged(merged)
    })
    expect(await projects.openFile(fileOf(text))).toBeNull()
    expect([names(), projects.told!.good]).toEqual([['one', 'two'], true])
    expect(projects.told!.text).toContain(m['projects.merged']({ added: 2, same: 0 }))
    // The list shows them before the dialog counts them.
    expect(shown).toEqual([['one', 'two']])
  })

  test('of a device with nothing on it is none', async () => {
    await projects.takeHome()
    expect(projects.told!.good).toBe(false)
  })
})

describe('what came of a home file', () => {
  const merged = (more: object): Merged =>
    ({ ...{ added: 1, copies: 0, same: 0, binned: 0, broken: 0, settings: {} }, ...more }) as Merged
  const first = () => m['projects.merged']({ added: 1, same: 0 })

  test.each<[object, () => string]>([
    [{ copies: 2 }, () => m['projects.mergedCopies']({ copies: 2 })],
    [{ binned: 1 }, () => m['projects.mergedBin']({ binned: 1 })],
    [{ settings: { taken: true } }, () => m['projects.mergedSettings']()],
    [{ settings: { kept: true } }, () => m['projects.keptSettings']()],
    [{ broken: 1 }, () => m['projects.mergedBroken']({ broken: 1 })],
  ])('%j is told after what was added', (more, sentence) => {
    projects.tellMerged(merged(more))
    expect(projects.told!.text).toBe(`${first()} ${sentence()}`)
    expect(projects.told!.good).toBe(!('broken' in more))
  })

  test('is one sentence where nothing else happened, and none where nothing came', () => {
    projects.tellMerged(merged({}))
    expect(projects.told).toEqual({ title: m['projects.mergedTitle'](), text: first(), good: true })
    projects.hush()
    projects.tellMerged(undefined)
    expect(projects.told).toBeNull()
  })
})
