import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { importsOf, isTool, unlike, workspacesIn, type Import, type Workspace } from './manifests.ts'
import { house, inHouse } from './prepare/house.mjs'

const workspaces = workspacesIn(house)

describe('the manifests', () => {
  test.each(workspaces.map((workspace) => [workspace.folder || 'the root', workspace] as const))(
    'of %s names what its code imports, and nothing else',
    (_, workspace) => {
      expect(unlike(workspace, (file) => importsOf(file, readFileSync(inHouse(file), 'utf8')))).toEqual([])
    },
  )

  test('are read of all workspaces with their code', () => {
    const withCode = workspaces.filter(({ files }) => files.length > 0).map(({ folder }) => folder)
    expect(withCode).toEqual(
      expect.arrayContaining(['', 'apps/cli', 'apps/web', 'benchmarks', 'e2e', 'packages/learning']),
    )
  })
})

const value = (from: string): Import => ({ from, isType: false })
const type = (from: string): Import => ({ from, isType: true })

describe('imports', () => {
  test('are found in every form, by the name of the package', () => {
    const code = `import 'svelte/reactivity'
import { a } from '@sveltejs/kit/vite'
import type { B } from 'mdast'
export { c } from 'fflate'
export type * from 'kysely'
const d = await import('pg')
type E = import('sax').SAXParser
// import 'commented'
const f = "import 'quoted'"`
    expect(importsOf('a.ts', code)).toEqual([
      ...[value('svelte'), value('@sveltejs/kit'), type('mdast'), value('fflate'), type('kysely')],
      ...[value('pg'), type('sax')],
    ])
  })

  test('of files, of Node and of aliases are none of packages', () => {
    const code = ['./a.ts', '../b.ts', 'node:fs', 'fs', '#parts/Knob.svelte', '$app/state', 'content:words']
    expect(importsOf('a.ts', code.map((from) => `import '${from}'`).join('\n'))).toEqual([])
  })

  test('of our own packages are found by their paths', () => {
    const code = "import '../../messages/folder.ts'\nimport '../check/a.ts'"
    expect(importsOf('packages/programs/run/a.ts', code)).toEqual([
      value('@botgarten/messages'),
      value('@botgarten/programs'),
    ])
  })

  test('of a component are those of its scripts and its markup', () => {
    const component = `<script lang="ts">
  import { scaleLinear } from 'd3-scale'
</script>
{#await import('@lezer/python')}…{/await}`
    expect(importsOf('A.svelte', component)).toEqual([value('d3-scale'), value('@lezer/python')])
  })

  test('of a style sheet are its fonts', () => {
    expect(importsOf('a.css', "@font-face { src: url('@fontsource-variable/nunito/a.woff2') }")).toEqual([
      value('@fontsource-variable/nunito'),
    ])
  })
})

const maps = (manifest: Omit<Workspace['manifest'], 'name'>, imports: { readonly [file: string]: Import }) =>
  unlike(
    {
      folder: 'packages/maps',
      manifest: { name: '@botgarten/maps', ...manifest },
      files: Object.keys(imports).map((name) => `packages/maps/${name}`),
    },
    (file) => [imports[file.slice('packages/maps/'.length)]!],
  )

describe('a manifest is wrong', () => {
  test('where the product imports what it does not name', () => {
    expect(maps({}, { 'a.ts': value('sax') })).toEqual(['packages/maps needs sax'])
    expect(maps({ devDependencies: { sax: '1' } }, { 'a.ts': value('sax') })).toEqual([
      'packages/maps needs sax',
      'packages/maps does not need sax for development',
    ])
  })

  test('where it names what only tests or types need', () => {
    const dependencies = { '@botgarten/lab': '*', mdast: '1' }
    expect(maps({ dependencies }, { 'a.test.ts': value('@botgarten/lab'), 'a.ts': type('mdast') })).toEqual([
      'packages/maps does not import @botgarten/lab',
      'packages/maps does not import mdast',
      'packages/maps needs @botgarten/lab for development',
      'packages/maps needs mdast for development',
    ])
  })

  test('where it names a neighbour that nothing imports', () => {
    expect(
      maps(
        { dependencies: { sax: '1' }, devDependencies: { '@botgarten/lab': '*' } },
        { 'a.ts': value('sax') },
      ),
    ).toEqual(['packages/maps does not need @botgarten/lab for development'])
  })

  test('and right with the types of a package that is imported for its types alone', () => {
    expect(maps({ devDependencies: { '@types/mdast': '4' } }, { 'a.ts': type('mdast') })).toEqual([])
  })
})

test('what builds the web app, tests and their helpers are tools', () => {
  const web = workspaces.find(({ folder }) => folder === 'apps/web')!
  const files = ['vite.config.ts', 'src/lab/a.ts', 'src/lab/a.test.ts', 'src/lab/testing/b.ts']
  expect(files.map((file) => isTool(web, `apps/web/${file}`))).toEqual([true, false, true, true])
})
