import { expect, test } from 'vitest'
import { closureOf, importsOf, keyOfTest, namedPaths } from './graph.mjs'

const imports = importsOf([
  { source: 'packages/lab/clock.test.ts', dependencies: [{ resolved: 'packages/lab/clock.ts' }] },
  { source: 'packages/lab/clock.ts', dependencies: [{ resolved: 'packages/numbers/sum.ts' }] },
  { source: 'packages/numbers/sum.ts', dependencies: [{ resolved: 'packages/lab/clock.ts' }] },
  { source: 'packages/maps/file.test.ts', dependencies: [{ resolved: 'node:fs' }] },
  { source: 'packages/maps/docs.test.ts', dependencies: [{ resolved: 'fs' }] },
  { source: 'packages/server/start.test.ts', dependencies: [{ resolved: 'child_process' }] },
  { source: 'apps/web/src/lab/undo.test.ts', dependencies: [] },
])

const tree = new Map([
  ['packages/lab/clock.test.ts', 'a'],
  ['packages/lab/clock.ts', 'b'],
  ['packages/lab/other.ts', 'c'],
  ['packages/numbers/sum.ts', 'd'],
  ['packages/maps/file.test.ts', 'e'],
  ['packages/maps/docs.test.ts', 'n'],
  ['packages/maps/notes.json', 'f'],
  ['docs/maps.md', 'o'],
  ['packages/server/start.test.ts', 'g'],
  ['apps/web/src/lab/undo.test.ts', 'h'],
  ['apps/web/src/lab/redo.ts', 'i'],
  // eslint-disable-next-line no-restricted-syntax -- a name; nothing is read
  ['content/maps/railway/map.svg', 'j'],
  ['content/words/en/lab.json', 'k'],
  ['package-lock.json', 'l'],
  ['README.md', 'm'],
])

const texts = new Map([
  ['packages/maps/docs.test.ts', "readFileSync(join(here, '../../docs/maps.md'), 'utf8')"],
])
const textOf = (path: string) => texts.get(path) ?? ''
const keyIn = (files: ReadonlyMap<string, string>, test: string) =>
  keyOfTest({ tree: files, imports, textOf }, test)

/** Does the key of a test change when this file changes? */
const decides = (file: string, about: string) =>
  keyIn(tree, about) !== keyIn(new Map([...tree, [file, 'changed']]), about)

test('a closure holds what is imported over any number of steps, also in a circle', () => {
  expect([...closureOf(imports, 'packages/lab/clock.test.ts')]).toEqual([
    'packages/lab/clock.test.ts',
    'packages/lab/clock.ts',
    'packages/numbers/sum.ts',
  ])
})

test('the key of a test is the same for the same files', () => {
  const file = 'packages/lab/clock.test.ts'
  expect(keyIn(tree, file)).toBe(keyIn(new Map(tree), file))
})

test.each([
  ['packages/lab/clock.test.ts', 'packages/lab/clock.test.ts', true],
  ['packages/numbers/sum.ts', 'packages/lab/clock.test.ts', true],
  ['packages/lab/other.ts', 'packages/lab/clock.test.ts', false],
  ['package-lock.json', 'packages/lab/clock.test.ts', true],
  ['README.md', 'packages/lab/clock.test.ts', false],
  // A test that reads files may read its own workspace and content/.
  ['packages/maps/notes.json', 'packages/maps/file.test.ts', true],
  // eslint-disable-next-line no-restricted-syntax -- a name; nothing is read
  ['content/maps/railway/map.svg', 'packages/maps/file.test.ts', true],
  ['packages/lab/other.ts', 'packages/maps/file.test.ts', false],
  // … and other files that it names.
  ['docs/maps.md', 'packages/maps/docs.test.ts', true],
  ['docs/maps.md', 'packages/maps/file.test.ts', false],
  // A test that starts processes may run any package.
  ['packages/lab/other.ts', 'packages/server/start.test.ts', true],
  ['apps/web/src/lab/redo.ts', 'packages/server/start.test.ts', false],
  // Tests of the web app read all words when they start.
  ['content/words/en/lab.json', 'apps/web/src/lab/undo.test.ts', true],
  ['apps/web/src/lab/redo.ts', 'apps/web/src/lab/undo.test.ts', false],
])('a change of %s decides about %s: %s', (file, about, expected) => {
  expect(decides(file, about)).toBe(expected)
})

test.each([
  ["new URL('../../../apps/web/src/', import.meta.url)", ['apps/web/src']],
  ["join(here, '../../docs/study.md')", ['packages/docs/study.md']],
  ["join(import.meta.dirname, '..', '..')", ['']],
  ["readdirSync(join(here, '../../..'))", ['']],
  ["import { a } from './near.ts'", []],
])('%s names %j in a test of packages/programs/check', (text, paths) => {
  expect(namedPaths('packages/programs/check/words.test.ts', text)).toEqual(paths)
})
