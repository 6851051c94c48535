import { expect, test } from 'vitest'
import { scriptsOf, type Counted } from './page-scripts.ts'

const chunk = (name: string, imports: string[] = [], dynamicImports: string[] = []) => ({
  ...{ file: `_app/immutable/${name}.js`, name, imports, dynamicImports },
})
const manifest = {
  start: chunk('entry/start', ['shared']),
  app: chunk('entry/app', ['shared'], ['home', 'lab']),
  shared: chunk('shared'),
  home: chunk('home', ['shared']),
  lab: chunk('lab', ['shared'], ['editor', 'build/later.ts', 'fear', 'maze']),
  fear: chunk('content-fear'),
  maze: chunk('content-maze'),
  'build/later.ts': chunk('build'),
  editor: chunk('editor', ['blockly']),
  blockly: chunk('blockly'),
}
const html = (page: string) =>
  ['entry/start', 'entry/app', page].map((name) => `<link href="./_app/immutable/${name}.js">`).join('')
const namesOf = (page: string, counted?: Counted) =>
  scriptsOf(html(page), manifest, (file) => file.length, counted)
    .map(({ name }) => name)
    .sort()

test('what a page loads by itself soon after counts, with what that imports in its turn', () => {
  expect(namesOf('lab')).toEqual(['blockly', 'editor', 'entry/app', 'entry/start', 'lab', 'shared'])
})

test('what only a click asks for is counted where it is wanted', () => {
  const own = ['blockly', 'build', 'editor', 'entry/app', 'entry/start', 'lab', 'shared']
  expect(namesOf('lab', { withLater: true })).toEqual(own)
})

test('of all cards and worlds only the one that is shown counts', () => {
  expect(namesOf('lab', { content: 'fear' })).toContain('content-fear')
  expect(namesOf('lab', { content: 'fear' })).not.toContain('content-maze')
})

test('the table of pages does not make a page pay for the others', () => {
  expect(namesOf('home')).toEqual(['entry/app', 'entry/start', 'home', 'shared'])
})

test('the largest comes first', () => {
  const sizes = scriptsOf(html('lab'), manifest, (file) => (file.includes('blockly') ? 9 : 1)).map(
    ({ bytes }) => bytes,
  )
  expect(sizes).toEqual([9, 1, 1, 1, 1, 1])
})

test('of the tables of words only those of the language that is spoken count', () => {
  const tables = ['en/app', 'de/app', 'en/blockly', 'de/blockly', 'de/tour'].map(
    (name) => `content:words/${name}`,
  )
  const words = Object.fromEntries(tables.map((name) => [name, chunk(name)]))
  const files = scriptsOf(
    '_app/immutable/page.js',
    { page: chunk('page', [], tables), ...words },
    (file) => file.length,
    { language: 'de' },
  )
  expect(files.map(({ name }) => name).sort()).toEqual([tables[1], tables[3], 'page'])
})

test('small tables of a language, which come together, count as late and in their language', () => {
  const manifest = {
    page: chunk('page', [], ['_a.js', '_b.js']),
    ...{ '_a.js': chunk('words-de'), '_b.js': chunk('words-en') },
  }
  const named = (counted: Counted) =>
    scriptsOf('_app/immutable/page.js', manifest, (file) => file.length, counted).map(({ name }) => name)
  expect(named({ language: 'de' })).toEqual(['page'])
  expect(named({ language: 'de', withLater: true }).sort()).toEqual(['page', 'words-de'])
})

test('what another playground asks for late does not count', () => {
  const later = ['q-learning', 'sorting'].map((name) => `src/features/${name}/later.ts`)
  const parts = Object.fromEntries(later.map((name) => [name, chunk(name)]))
  const files = scriptsOf(
    '_app/immutable/page.js',
    { page: chunk('page', [], later), ...parts },
    (file) => file.length,
    { withLater: true, playground: 'sorting' },
  )
  expect(files.map(({ name }) => name).sort()).toEqual(['page', later[1]])
})
