import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, test } from 'vitest'

const here = import.meta.dirname
const read = (path: string) => readFileSync(join(here, path), 'utf8')
const specs = readdirSync(join(here, 'tests')).map((name) => `tests/${name}`)
const drivers = readdirSync(here).filter((name) => /^(child.*|navigation)\.ts$/.test(name))

const reason = /^\s*\/\/ By address: \S+/
/** Home is where every test begins. */
const entersByAddress = /\.goto\((?!'\/'[,)])|\.opensLabByAddress\(/

/** Lines that open a page by its address without saying why: in the line before, or for the whole file below its rooms. */
function unexplained(text: string): readonly string[] {
  const lines = text.split('\n')
  if (reason.test(lines[1] ?? '')) return []
  return lines.filter((line, at) => entersByAddress.test(line) && !reason.test(lines[at - 1] ?? ''))
}

describe('entering as a child does', () => {
  test.each([...specs, ...drivers])('%s opens pages by clicks, or says why by address', (path) => {
    expect(unexplained(read(path))).toEqual([])
  })

  test('a reason belongs to one line, or to the file whose second line it is', () => {
    const call = "  await page.goto('/lab/fear')"
    expect(unexplained(`// Rooms: lab\n${call}`)).toEqual([call])
    expect(unexplained(`// Rooms: lab\n\n  // By address: a link.\n${call}\n${call}`)).toEqual([call])
    expect(unexplained(`// Rooms: lab\n// By address: links.\n${call}\n${call}`)).toEqual([])
    expect(unexplained("await page.goto('/')\nawait page.goto('/', { waitUntil: 'commit' })")).toEqual([])
    expect(unexplained("await child.opensLabByAddress('fear')")).toHaveLength(1)
  })
})

/** Rooms whose faults lose work. */
const careful = new Set(['storage', 'class'])
/** Tests of saving and restoring whose files belong to other rooms. */
const alsoCareful: { readonly [spec: string]: string } = {
  'tests/undo.spec.ts': 'undo and redo',
  'tests/projects.spec.ts': 'the list of projects, its bin and the home file',
  'tests/said.spec.ts': 'saved work that cannot be read',
  'tests/links.spec.ts': 'a project as a link',
  'tests/offline.spec.ts': 'work without a network',
  'tests/health.spec.ts': 'backup and restore',
  'tests/teacher.spec.ts': 'the data of a class',
}

const roomsOf = (text: string): readonly string[] =>
  /^\/\/ Rooms: (.*)$/m
    .exec(text)?.[1]
    ?.split(',')
    .map((room) => room.trim()) ?? []

/** axe reads pages and saves nothing. */
const isAxe = (path: string) => path.startsWith('tests/axe')
const isCareful = (path: string) =>
  path in alsoCareful || (!isAxe(path) && roomsOf(read(path)).some((room) => careful.has(room)))

describe('what must not be lost', () => {
  test('the files of other rooms that are named here exist', () => {
    expect(specs).toEqual(expect.arrayContaining(Object.keys(alsoCareful)))
  })

  test.each(specs.filter(isCareful))('%s gets no further try', (path) => {
    expect(read(path)).toMatch(/^ *test\.describe\.configure\(\{ retries: 0 \}\)$/m)
  })
})
