// Contract of the walk of `npm test`: each of its tests is tagged with its features and pages, and every one has a tag.
import { globSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'

const web = join(import.meta.dirname, '../apps/web/src')
const read = (folder: string, file: string) => readFileSync(join(folder, file), 'utf8')
const unique = (names: readonly string[]) => [...new Set(names)].toSorted()

/** The id in a feature's door. */
const features = globSync('features/*/feature.ts', { cwd: web }).map(
  (file) => /^ {2}id: '([\w-]+)',$/m.exec(read(web, file))?.[1] ?? file,
)

/** Addresses of pages as their folders say them: `/lab/[card]`. The page for an unknown address is `/+error`. */
const pages = globSync('routes/**/+{page,error}.svelte', { cwd: web }).map((file) =>
  file
    .replaceAll('\\', '/')
    .replace(/^routes/, '')
    .replace(/\/\+page\.svelte$/, '')
    .replace(/\.svelte$/, ''),
)

const specsIn = (folder: string) =>
  globSync('*.spec.ts', { cwd: join(import.meta.dirname, folder) }).map((file) => ({
    file: `${folder}/${file}`,
    text: read(join(import.meta.dirname, folder), file),
  }))
const specs = specsIn('gate')
const steps = specsIn('steps')
const tagsOf = (files: typeof specs) =>
  files.flatMap(({ text }) => [...text.matchAll(/'@([\w-]+|\/[^']*)'/g)].map(([, tag]) => tag!))
const tags = tagsOf(specs)
const isPage = (tag: string) => tag.startsWith('/')

test('the walk goes through the main path of every feature', () => {
  expect(unique(tags.filter((tag) => !isPage(tag)))).toEqual(unique(features))
})

test('steps go through every feature', () => {
  expect(unique(tagsOf(steps))).toEqual(unique(features))
})

test('the walk goes through every page', () => {
  expect(unique(tags.filter(isPage))).toEqual(unique(pages.map((page) => page || '/')))
})

test.each([...specs, ...steps])('every test of $file has a tag with its features and pages', ({ text }) => {
  const tests = [...text.matchAll(/^test\(/gm)].length
  expect(tests).toBeGreaterThan(0)
  expect([...text.matchAll(/^.*\btag: /gm)]).toHaveLength(tests)
})

/** Names of files with steps, as the specs give them: `goesThrough(child, 'races', …)`. */
const stepped = steps.flatMap(({ text }) =>
  [...text.matchAll(/goesThrough\(\s*child,\s*'([\w-]+)'/g)].map(([, name]) => name!),
)

test('each file of changes belongs to one walk through steps', () => {
  const written = globSync('*.txt', { cwd: join(import.meta.dirname, 'steps/trees') }).map((file) =>
    file.replace(/\.txt$/, ''),
  )
  expect(stepped.toSorted()).toEqual(written.toSorted())
})
