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

/** Playwright's own reads, which do not wait for a state. */
const reads = [
  ...['allInnerTexts', 'allTextContents', 'ariaSnapshot', 'boundingBox', 'count', 'evaluate', 'evaluateAll'],
  ...[
    'getAttribute',
    'innerHTML',
    'innerText',
    'inputValue',
    'isChecked',
    'isDisabled',
    'isEnabled',
    'isVisible',
  ],
  ...['textContent', 'title'],
]
/** A driver's method that any test polls reads a page, too. */
const polled = /expect\s*\.poll\((?:async )?\(\) => \(*(?:await )?[\w.]+\.(\w+)\(/g

/**
 * Expectations that read a page a single time and so fail while it is still about to change. Answers of a server, files
 * and events arrive once and may be awaited directly.
 */
function singleReads(text: string, methods: readonly string[]): readonly string[] {
  const expected = text
    .replaceAll(/\s+/g, ' ')
    .match(/\bexpect\((?!async )(?:(?!\)\.(?:not\.)?to[A-Z]).)*await .*?\)\.(?:not\.)?to[A-Z]/g)
  const look = new RegExp(`await [^ ]*\\.(?:${methods.join('|')})\\(`)
  return (expected ?? []).filter((one) => look.test(one))
}

describe('reading a page', () => {
  const inFolder = (folder: string) =>
    readdirSync(join(here, folder))
      .filter((name) => name.endsWith('.ts'))
      .map((name) => `${folder}/${name}`)
  const files = [...specs, ...['gate', 'steps', 'walk'].flatMap(inFolder), ...drivers]
  const found = files.flatMap((path) => [...read(path).matchAll(polled)].map(([, method]) => method!))
  const methods = [...new Set([...reads, ...found])].filter((method) => method !== 'ask')

  test('finds what drivers read', () => {
    expect(methods).toEqual(expect.arrayContaining(['names', 'blockWords', 'boStands', 'hashOfWeights']))
  })

  test.each(files)('%s expects a state with expect.poll, never with a single read', (path) => {
    expect(singleReads(read(path), methods)).toEqual([])
  })

  test('a single read is found over several lines and in a calculation; a file is not', () => {
    const found = (text: string) => singleReads(text, ['names', 'count'])
    expect(found('expect(await list.names()).toEqual([])')).toHaveLength(1)
    expect(found('expect(\n  (await there.names()).toSorted(),\n).not.toEqual([])')).toHaveLength(1)
    expect(found('await expect.poll(() => list.names()).toEqual([])')).toEqual([])
    expect(found("expect(await readFile('names.txt')).toEqual(await list.names())")).toEqual([])
    expect(found('expect(a).toBe(1)\nawait list.names()\nexpect(b).toBe(2)')).toEqual([])
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
