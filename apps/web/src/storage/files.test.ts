import { writeProject, type Project } from '@botgarten/programs'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { throwAway } from './bin.ts'
import { homeFiles, keepProject, openProjectFile, type OpenedFile } from './files.ts'
import { list, load, save } from './projects.ts'
import { fillDisk, freshDevice } from './testing/device.ts'
import { fear, friendship, tooMuch } from './testing/sample.ts'

// Files as a child opens them, on a device with a real storage.
const drawer = new Map<string, string>()
let fullDrawer = false

beforeEach(async () => {
  await freshDevice()
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  drawer.clear()
  fullDrawer = false
  vi.stubGlobal('localStorage', {
    getItem: (name: string) => drawer.get(name) ?? null,
    setItem(name: string, text: string) {
      if (fullDrawer) throw new DOMException('Full for a test.', 'QuotaExceededError')
      drawer.set(name, text)
    },
    removeItem: (name: string) => void drawer.delete(name),
  })
})
afterEach(() => vi.unstubAllGlobals())

const file = (name: string, text: string) => new File([text], name)
/** A file that says to be so large; what is in it is not looked at for that. */
const large = (name: string, size: number, text = '') =>
  ({ name, size, text: () => Promise.resolve(text) }) as File
const opens = (project: unknown, name = 'a.botgarten.json') =>
  openProjectFile(file(name, typeof project === 'string' ? project : JSON.stringify(project)))
const idIn = (opened: OpenedFile) => ('id' in opened ? opened.id : '')
/** What the browser's own download would hold. */
async function saved(files: Awaited<ReturnType<typeof homeFiles>>) {
  const blobs: Blob[] = []
  vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => `blob:${blobs.push(blob as Blob)}`)
  vi.stubGlobal('document', { createElement: () => ({ click: () => {} }) })
  for (const one of files) one.save()
  return Promise.all(blobs.map((blob) => blob.text()))
}
const mine = (project: Project, name: string): Project => ({ ...project, name })

describe('a project file', () => {
  test('becomes a project of this device, beside those that are here', async () => {
    await save('friendship', mine(friendship, 'here'), 0)
    const opened = await opens(writeProject(friendship))
    expect(opened).toEqual({ id: expect.stringMatching(/^friendship-\w+$/) as string, project: friendship })
    expect((await load(idIn(opened)))?.project).toEqual(friendship)
    expect((await load('friendship'))?.project.name).toBe('here')
  })

  test('of a card that is not there goes into the free lab', async () => {
    expect(idIn(await opens({ ...friendship, card: 'cooking' }))).toMatch(/^free-/)
  })

  test('of an unknown card still names that card when it is saved again', async () => {
    const id = idIn(await opens({ ...friendship, card: 'cooking' }))
    expect(JSON.parse(writeProject((await load(id))!.project))).toMatchObject({ card: 'cooking' })
  })

  const program = writeProject(friendship)
  test.each([
    ['no JSON', 'a photo of my cat', 'notJson'],
    ['an empty text', '', 'notJson'],
    ['a newer version', '{"botgarten":9}', 'newerVersion'],
    ['JSON of another shape', '{"botgarten":1,"name":"x"}', 'notAProject'],
    ['JSON without a version', '{"programs":{}}', 'notAProject'],
    [
      'a key that reaches into every object',
      program.replace('"programs":{', '"programs":{"__proto__":{"polluted":true},'),
      'notAProject',
    ],
    [
      'a world without a robot',
      JSON.stringify({ ...friendship, world: { ...friendship.world, robots: [] } }),
      'notAProject',
    ],
    ['a newer home file', '{"botgartenHome":9,"projects":[]}', 'newerVersion'],
    ['a home file without projects', '{"botgartenHome":2}', 'notAProject'],
    ['a name that looks like a home file', '{"name":"\\"botgartenHome\\""}', 'notAProject'],
  ])('%s is refused, and what is here stays unchanged', async (_, text, problem) => {
    await save('friendship', mine(friendship, 'here'), 0)
    expect(await opens(text)).toMatchObject({ problem })
    expect((await list()).projects.map(({ project }) => project.name)).toEqual(['here'])
    expect('polluted' in {}).toBe(false)
  })

  test('that is too much opens as far as it can, and says so', async () => {
    const opened = await opens(tooMuch)
    expect(opened).toMatchObject({ lost: true, project: { card: 'friendship' } })
    expect((await load(idIn(opened)))?.project.name).toHaveLength(20_000)
  })

  test('of more parts than any project has is not opened in parts', async () => {
    const text = JSON.stringify({ ...friendship, sorting: { rows: Array<number>(1_000_001).fill(0) } })
    expect(text.length).toBeLessThan(5_000_000)
    expect(await opens(text)).toEqual({ problem: 'tooBig', facts: {} })
  })

  test('that finds no room says so, and so does one that is too much for it', async () => {
    fillDisk()
    expect(await opens(friendship)).toEqual({ problem: 'notKept', facts: {} })
    expect(await opens(tooMuch)).toEqual({ problem: 'notKept', facts: {} })
    expect(await keepProject(tooMuch)).toEqual({ problem: 'tooMuch', facts: {} })
  })

  test('has at most 5 MB, a home file 100 MB; what is larger is not even read', async () => {
    const text = writeProject(friendship)
    const tooBig = { problem: 'tooBig', facts: {} }
    const homeTooBig = { problem: 'homeTooBig', facts: {} }
    expect(await openProjectFile(large('a.json', 5_000_000, text))).toMatchObject({ project: friendship })
    expect(await openProjectFile(large('a.json', 5_000_001, text))).toEqual(tooBig)
    expect(await openProjectFile(large('a.XML', 5_000_001, '<export/>'))).toEqual(tooBig)
    expect(await openProjectFile(large('a.xml', 5_000_000, '<html/>'))).toMatchObject({
      problem: 'notOpenRoberta',
    })
    const home = '{"botgartenHome":2,"projects":[],"bin":[],"settings":{}}'
    expect(await openProjectFile(large('a.json', 100_000_000, home))).toMatchObject({ merged: { added: 0 } })
    expect(await openProjectFile(large('a.json', 100_000_001, home))).toEqual(homeTooBig)
  })

  test('a fault of ours is not told as one of the file', async () => {
    const broken = { name: 'a', size: 1, text: () => Promise.reject(new RangeError('A fault.')) }
    await expect(openProjectFile(broken as unknown as File)).rejects.toThrow('A fault.')
  })
})

describe('all of a device as a file', () => {
  const day = new Date('2026-11-22T12:00:00Z')

  test('is none where there is nothing', async () => {
    expect(await homeFiles()).toEqual([])
  })

  test('takes projects, bin and settings to another device, where all of it is new', async () => {
    await save('friendship', mine(friendship, 'one'), 0)
    await save('fear', mine(fear, 'two'), 0)
    await throwAway('fear')
    drawer.set('botgarten.sound', 'false')
    const files = await homeFiles(day)
    expect(files.map(({ name }) => name)).toEqual([expect.stringMatching(/ 2026-11-22$/)])
    const [text] = await saved(files)
    await freshDevice()
    vi.spyOn(console, 'warn').mockImplementation(() => {})
    drawer.clear()
    expect(await opens(text!)).toEqual({
      merged: {
        ...{ added: 1, copies: 0, same: 0, binned: 1, broken: 0 },
        settings: { taken: true, kept: false },
      },
    })
    expect((await load('friendship'))?.project.name).toBe('one')
    expect(drawer.get('botgarten.sound')).toBe('false')
    expect(await opens(text!)).toMatchObject({
      merged: { added: 0, same: 1, binned: 0, settings: { taken: false, kept: false } },
    })
  })

  test('leaves what is here as it is: another project of one key is a copy, other settings stay', async () => {
    await save('friendship', mine(friendship, 'theirs'), 0)
    drawer.set('botgarten.sound', 'false')
    const [text] = await saved(await homeFiles(day))
    await freshDevice()
    vi.spyOn(console, 'warn').mockImplementation(() => {})
    await save('friendship', mine(fear, 'mine'), 0)
    drawer.set('botgarten.sound', 'true')
    expect(await opens(text!)).toMatchObject({
      merged: { added: 1, copies: 1, settings: { taken: false, kept: true } },
    })
    expect((await load('friendship'))?.project.name).toBe('mine')
    const names = (await list()).projects.map(({ project }) => project.name)
    expect(names.toSorted()).toEqual(['mine', expect.stringMatching(/^theirs \(.+\)$/)])
    expect(drawer.get('botgarten.sound')).toBe('true')
  })

  test('settings alone are none; sorted work of an earlier version goes home as a project', async () => {
    drawer.set('botgarten.sound', 'false')
    expect(await homeFiles(day)).toEqual([])
    drawer.set('botgarten.sorting', '{"source":"points"}')
    const [text] = await saved(await homeFiles(day))
    expect(JSON.parse(text!)).toMatchObject({
      projects: [{ id: 'sorting', project: { playground: 'sorting', sorting: { source: 'points' } } }],
    })
    expect(JSON.parse(text!)).not.toHaveProperty('settings.sorting')
  })

  test('sorted work in a home file of an earlier version becomes a project, and only once', async () => {
    const sorting = { source: 'points', set: '' }
    const home = { botgartenHome: 2, projects: [], bin: [], settings: { sorting } }
    for (let time = 0; time < 2; time += 1) {
      expect(await opens(home)).toMatchObject({ merged: { settings: { taken: false, kept: false } } })
      expect((await list()).projects.map(({ id, project }) => [id, project.sorting])).toEqual([
        ['sorting', sorting],
      ])
    }
  })

  test('that finds no room is told so, whatever of it does not fit', async () => {
    const project = { id: 'friendship', changed: 1, project: friendship }
    const home = { botgartenHome: 2, projects: [project], bin: [], settings: { sound: false } }
    fullDrawer = true
    expect(await opens(home)).toEqual({ problem: 'notKept', facts: {} })
    fullDrawer = false
    fillDisk()
    expect(await opens({ ...home, projects: [{ ...project, id: 'friendship-2', project: fear }] })).toEqual({
      problem: 'notKept',
      facts: {},
    })
  })

  test('a language and comforts that come along are seen at once', async () => {
    const { language } = await import('#words/language.svelte.ts')
    const { comfort } = await import('#storage/comfort.svelte.ts')
    await language.speak('en')
    // As on a device where nobody has chosen one yet.
    drawer.clear()
    const settings = {
      language: 'de',
      comfort: { projector: false, quiet: true, letters: false, aloud: false },
    }
    await opens({ botgartenHome: 2, projects: [], bin: [], settings })
    await vi.waitFor(() => expect(language.locale).toBe('de'))
    expect([comfort.has('quiet'), comfort.has('letters')]).toEqual([true, false])
    await language.speak('en')
  })
})
