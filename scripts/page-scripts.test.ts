import { expect, test } from 'vitest'
import { scriptsFrom, scriptsOf, type Asks } from './page-scripts.ts'

const chunk = (name: string, imports: string[] = [], dynamicImports: string[] = []) => ({
  ...{ file: `_app/immutable/${name}.js`, name, imports, dynamicImports },
})
const manifest = {
  start: chunk('entry/start', ['shared']),
  app: chunk('entry/app', ['shared'], ['home', 'lab']),
  shared: chunk('shared'),
  home: chunk('home', ['shared']),
  lab: chunk('lab', ['shared'], ['editor', 'build']),
  build: chunk('build'),
  editor: chunk('editor', ['blockly']),
  blockly: chunk('blockly'),
}
const html = (page: string) =>
  ['entry/start', 'entry/app', page].map((name) => `<link href="./_app/immutable/${name}.js">`).join('')
const namesOf = (page: string, asks?: Asks) =>
  scriptsOf(html(page), manifest, (file) => file.length, asks)
    .map(({ name }) => name)
    .sort()

test('of what a page may ask for only what is said to count counts, with what that imports in its turn', () => {
  expect(namesOf('lab')).toEqual(['entry/app', 'entry/start', 'lab', 'shared'])
  expect(namesOf('lab', (source) => source === 'editor')).toEqual([
    'blockly',
    'editor',
    'entry/app',
    'entry/start',
    'lab',
    'shared',
  ])
})

test('the table of pages does not make a page pay for the others', () => {
  expect(namesOf('home', () => true)).toEqual(['entry/app', 'entry/start', 'home', 'shared'])
})

test('the largest comes first', () => {
  const sizes = scriptsFrom(['editor', 'home'], manifest, (file) => (file.includes('blockly') ? 9 : 1)).map(
    ({ bytes }) => bytes,
  )
  expect(sizes).toEqual([9, 1, 1, 1])
})
