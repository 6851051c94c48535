import { execFileSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { inHouse } from '../scripts/prepare/house.mjs'
import { isDocument, passagesOf } from '../scripts/prose/passages.ts'
import { proseFiles, readFile } from '../scripts/prose/tree.ts'
import { matchesOf, wordsIn } from '../scripts/prose/words.ts'
import type { Table } from './bench.ts'

const hono = '4.13.19'

/** A file with its path, which decides how it is read. */
interface Source {
  readonly path: string
  readonly text: string
}

const parts: readonly [string, (path: string) => boolean][] = [
  ['packages', (path) => path.startsWith('packages/')],
  ['apps/web', (path) => path.startsWith('apps/web/')],
  ['apps/cli', (path) => path.startsWith('apps/cli/')],
  ['scripts', (path) => path.startsWith('scripts/')],
  ['e2e', (path) => path.startsWith('e2e/')],
  ['benchmarks', (path) => path.startsWith('benchmarks/')],
]

/** Declarations and modules of a published package, without the copies for CommonJS and bundled files. */
const publishedIn = (folder: string): Source[] =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((path) => /\.(d\.ts|js)$/.test(path) && !/(^|\/)(cjs|bundles?|node_modules)\//.test(path))
    .map((path) => ({ path, text: readFileSync(join(folder, path), 'utf8') }))

function honoSources(): Source[] {
  const folder = mkdtempSync(join(tmpdir(), 'hono-'))
  try {
    execFileSync('npm', ['pack', '--silent', `hono@${hono}`], { cwd: folder })
    execFileSync('tar', ['-xzf', `hono-${hono}.tgz`], { cwd: folder })
    return publishedIn(join(folder, 'package', 'dist'))
  } finally {
    rmSync(folder, { recursive: true })
  }
}

const versionOf = (name: string) =>
  (JSON.parse(readFileSync(inHouse('node_modules', name, 'package.json'), 'utf8')) as { version: string })
    .version

const installed = (name: string, ...folders: string[]): [string, Source[]] => [
  `${name} ${versionOf(name)}`,
  publishedIn(inHouse('node_modules', name, ...folders)),
]

function row(name: string, sources: readonly Source[]): (string | number)[] {
  const words = sources.flatMap(({ path, text }) => passagesOf(path, text).map(wordsIn))
  const sum = words.reduce((all, one) => all + one, 0)
  const matches = sources.flatMap(({ path, text }) => matchesOf(path, text)).length
  return [name, sources.length, sum, matches, ((1000 * matches) / sum).toFixed(1)]
}

/** How many phrases of scripts/prose/words.json comments and documents contain. */
export default function prose(): Table {
  const all = proseFiles().map((path) => ({ path, text: readFile(path) }))
  const code = all.filter(({ path }) => !isDocument(path))
  const documents = all.filter(({ path }) => isDocument(path))
  const others: [string, Source[]][] = [
    installed('kysely', 'dist', 'esm'),
    [`hono ${hono}`, honoSources()],
    installed('svelte', 'src'),
    installed('@types/node'),
    installed('eslint', 'lib'),
    installed('fast-check', 'lib'),
  ]
  return {
    title: 'Phrases to avoid in comments and documents',
    how: 'Matches of the rows of scripts/prose/words.json in comments, without code in them, and in Markdown documents. Packages of others: the comments of their declarations and modules as published on npm.',
    columns: ['part', 'files', 'words', 'phrases', 'per 1,000 words'],
    rows: [
      ...parts.map(([name, isIn]) =>
        row(
          name,
          code.filter(({ path }) => isIn(path)),
        ),
      ),
      row('all comments', code),
      row('documents', documents),
      ...others.map(([name, sources]) => row(name, sources)),
    ],
    notes: ['Texts for children in content/ are not counted: they have checks of their own.'],
  }
}
