import { createHash } from 'node:crypto'
import { existsSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, join, relative } from 'node:path'
import { house, inHouse } from './house.mjs'
import { run, runQuietly, Trouble } from './run.mjs'
import { runtime } from './runtime.mjs'

const web = inHouse('apps', 'web')
const stamp = join(web, 'build', 'sources.sha256')
const webSpaceStamp = inHouse('build', 'web-space.sha256')
const sources = [
  'apps/web/src',
  'apps/web/static',
  'apps/web/package.json',
  ...['chunks', 'data', 'examples', 'notices', 'vite.config', 'web-space', 'words'].map(
    (name) => `apps/web/${name}.ts`,
  ),
  'NOTICE',
  'content',
  'package-lock.json',
  'packages',
]
const made = new Set(['node_modules', 'generated'])

/** @param {string} path @returns {string[]} every file below, tests left out, in one order everywhere */
function filesBelow(path) {
  const entries = readdirSync(path, { withFileTypes: true }).filter((entry) => !made.has(entry.name))
  return entries
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) => (entry.isDirectory() ? filesBelow(join(path, entry.name)) : [join(path, entry.name)]))
    .filter((file) => !file.endsWith('.test.ts'))
}

/** One hash over names and contents of everything that the build is made from. */
function hashOfSources() {
  const hash = createHash('sha256')
  for (const source of sources) {
    const path = join(house, source)
    for (const file of statSync(path).isFile() ? [path] : filesBelow(path)) {
      hash
        .update(`${relative(house, file).replaceAll('\\', '/')}\0`)
        .update(readFileSync(file))
        .update('\0')
    }
  }
  return hash.digest('hex')
}

const vite = () =>
  join(dirname(createRequire(join(web, 'package.json')).resolve('vite/package.json')), 'bin', 'vite.js')

/**
 * Builds the web app.
 * @param {(program: string, args: string[], options: { cwd: string }) => number | Promise<number>} [start]
 */
export async function build(start = run) {
  const hash = hashOfSources()
  const code = await start(runtime(), [vite(), 'build'], { cwd: web })
  if (code !== 0) throw new Trouble('The build failed; what Vite said stands above.', code)
  writeFileSync(stamp, hash)
}

/** The folder that `npm run build:static` writes. */
export const webSpace = inHouse('build', 'web-space')

/**
 * Builds files for a web space.
 * @param {(program: string, args: string[], options: object) => number | Promise<number>} [start]
 */
export async function buildStatic(start = run) {
  const hash = hashOfSources()
  const env = { ...process.env, BOTGARTEN_WEB_SPACE: webSpace }
  const code = await start(runtime(), [vite(), 'build'], { cwd: web, env })
  if (code !== 0) throw new Trouble('The build failed; what Vite said stands above.')
  writeFileSync(webSpaceStamp, hash)
}

/** Builds the files for a web space when a source is not the one that was built. */
export async function buildStaticWhenNeeded() {
  if (existsSync(webSpaceStamp) && readFileSync(webSpaceStamp, 'utf8') === hashOfSources()) return
  await buildStatic(runQuietly)
}

/** Is a source not the one that was built? */
export const isToBeBuilt = () => !existsSync(stamp) || readFileSync(stamp, 'utf8') !== hashOfSources()

/** Builds the web app when a source is not the one that was built. */
export async function buildWhenNeeded() {
  if (!isToBeBuilt()) return
  console.log('Building the lab (once after every change) …')
  await build(runQuietly)
}
