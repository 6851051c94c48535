import { version, type Project } from '@botgarten/programs'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { handOut, saveProjectFile, saveRaw, isOpenRoberta, isProgramFile } from './handout.ts'
import { friendship } from './testing/sample.ts'

/** What the browser was given to download. */
const given: { name: string; blob: Blob | undefined }[] = []
const addresses = new Map<string, Blob>()

beforeEach(() => {
  vi.useFakeTimers()
  given.length = 0
  addresses.clear()
  vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => {
    addresses.set('blob:1', blob as Blob)
    return 'blob:1'
  })
  vi.spyOn(URL, 'revokeObjectURL').mockImplementation((address) => void addresses.delete(address))
  vi.stubGlobal('document', {
    createElement: (tag: string) => ({
      href: '',
      download: '',
      click(this: { href: string; download: string }) {
        expect(tag).toBe('a')
        given.push({ name: this.download, blob: addresses.get(this.href) })
      },
    }),
  })
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

test('a project is handed out under its name, and says which version wrote it', async () => {
  saveProjectFile({ ...friendship, name: 'Bo fährt' })
  expect(given[0]!.name).toBe('Bo fährt.botgarten.json')
  expect(given[0]!.blob!.type).toBe('application/json')
  const { madeWith, ...project } = JSON.parse(await given[0]!.blob!.text()) as Project & { madeWith: string }
  expect(madeWith).toBe(version)
  expect(project).toEqual({ ...friendship, name: 'Bo fährt' })
})

test('the address is given back, but not before the browser has read it', () => {
  handOut('a', 'b')
  vi.advanceTimersByTime(999)
  expect(addresses.size).toBe(1)
  vi.advanceTimersByTime(1)
  expect(addresses.size).toBe(0)
})

test.each([
  ['xml', 'application/xml'],
  ['csv', 'text/csv'],
  ['zip', 'application/zip'],
  ['json', 'application/json'],
  ['brain.json', 'application/json'],
] as const)('a file that ends in %s is %s', (ending, type) => {
  handOut('a', 'b', ending)
  expect([given[0]!.name, given[0]!.blob!.type]).toEqual([`a.${ending}`, type])
})

test('a name is one that every system takes', () => {
  handOut('../a:b?*"c" _-1', '')
  handOut('//', '')
  handOut('n'.repeat(99), '')
  expect(given.map(({ name }) => name.replace('.botgarten.json', ''))).toEqual([
    'abc _-1',
    'botgarten',
    'n'.repeat(80),
  ])
})

test('what cannot be read is handed out as it lies there', async () => {
  saveRaw('damaged', { programs: 1n })
  expect(given[0]!.name).toBe('damaged.json')
  expect(await given[0]!.blob!.text()).toBe('{"programs":"1"}')
})

test('a program is known by the end of its file’s name', () => {
  expect(['a.xml', 'A.XML', 'a.botgarten', 'a.botgarten.json'].every(isProgramFile)).toBe(true)
  expect(['a.json', 'a.png', 'xml', 'a.xml.png'].some(isProgramFile)).toBe(false)
})

test('Open Roberta’s files are known by name, or by their beginning', () => {
  expect(isOpenRoberta('a.xml', 'whatever')).toBe(true)
  expect(isOpenRoberta('a.txt', '\uFEFF<?xml version="1.0"?>\n<export xmlns="x">')).toBe(true)
  expect(isOpenRoberta('a.json', '{"name":"<export>"}')).toBe(false)
  expect(isOpenRoberta('a.json', '<exporter>')).toBe(false)
})

test('only the first 1000 letters are looked at for that', () => {
  expect(isOpenRoberta('a.txt', `${' '.repeat(992)}<export>`)).toBe(true)
  expect(isOpenRoberta('a.txt', `${' '.repeat(993)}<export>`)).toBe(false)
})
