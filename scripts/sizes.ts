// `npm run check:sizes`: three budgets for a build: the scripts of the lab's first load, those of any other page's first load,
// and the whole offline copy. A lazy part adds 100 kB at most, unless the door of its feature names a budget.
import { existsSync, readFileSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { scriptsFrom, scriptsOf, type Asks, type Manifest, type Script } from './page-scripts.ts'
import { inHouse } from './prepare/house.mjs'

export interface Size {
  /** A page, the lazy part of a feature (what it adds to its page), or the offline copy. */
  readonly what: string
  /** Of a page or a part its scripts, of the offline copy all its files. */
  readonly files: readonly Script[]
  /** Bytes of all files as they are sent, with brotli where they are compressed. */
  readonly bytes: number
  readonly budget: number
}

/** What a feature says of itself in its door. */
interface Feature {
  readonly id: string
  readonly route?: string
  /** Of its lazy part. */
  readonly budget?: number
}

const web = inHouse('apps', 'web')
const client = join(web, 'build', 'client')
const kB = 1000
/** Most bytes of scripts of a page's first load, of a lazy part whose door names no budget, and of all files of the offline copy. */
const budgets = { lab: 450 * kB, page: 320 * kB, part: 100 * kB, offline: 3400 * kB }
/** The language whose words are longest. */
const language = 'de'

const readJson = (...path: string[]) => JSON.parse(readFileSync(join(web, ...path), 'utf8')) as unknown

const wordsOf = (source: string) => /content:words\/(\w+)\/([\w-]+)$/.exec(source)
/** Words that every page and the blocks say. */
const wordsAtOnce = ['app', 'blockly']

/** What a page with this card asks for by itself: its words, its card, parts of these features. */
const atOnce =
  (card: string | null, features: readonly string[]): Asks =>
  (source) => {
    const [, locale, file = ''] = wordsOf(source) ?? []
    if (locale) return locale === language && wordsAtOnce.includes(file)
    return source === `content:card/${card}` || features.some((id) => source === `src/features/${id}/lazy.ts`)
  }

/** Files that the service worker caches, as its list in the build names them; pages are not among them. */
function offlineFiles(sizeOf: (file: string) => number): Script[] {
  const worker = readFileSync(join(client, 'service-worker.js'), 'utf8')
  const listed = [...worker.matchAll(/path:`([^`]+)`/g)].map(([, file]) => file!)
  const ofTeachers = new Set([...worker.matchAll(/[^:]`(_app\/immutable\/[^`]+)`/g)].map(([, file]) => file!))
  return listed
    .filter((file) => !ofTeachers.has(file) && existsSync(join(client, file)))
    .map((file) => ({ file, name: file, bytes: sizeOf(file) }))
    .toSorted((a, b) => b.bytes - a.bytes)
}

/** Sizes of the present build. */
export function measure(): Size[] {
  const manifest = readJson('.svelte-kit', 'output', 'client', '.vite', 'manifest.json') as Manifest
  const features = readJson('build', 'prerendered', 'features.json') as Feature[]
  const htmlOf = (page: string) =>
    readFileSync(join(web, 'build', 'prerendered', `${page || 'index'}.html`), 'utf8')
  const sizeOf = (file: string) => {
    const packed = join(client, `${file}.br`)
    return statSync(existsSync(packed) ? packed : join(client, file)).size
  }
  const sized = (what: string, files: readonly Script[], budget: number): Size => {
    return { what, files, bytes: files.reduce((sum, { bytes }) => sum + bytes, 0), budget }
  }
  /** What `load` of a feature's door imports. */
  const lazyOf = (id: string) =>
    Object.keys(manifest).filter((source) =>
      new RegExp(`^src/features/${id}/[^/]+\\.(ts|svelte)$`).test(source),
    )
  const card = 'friendship'
  const lab = scriptsOf(htmlOf(`lab/${card}`), manifest, sizeOf, atOnce(card, ['editor']))
  const sizes = [sized('lab', lab, budgets.lab), sized('offline copy', offlineFiles(sizeOf), budgets.offline)]
  for (const { id, route, budget = budgets.part } of features) {
    const own = route === undefined ? [] : scriptsOf(htmlOf(route), manifest, sizeOf, atOnce(null, []))
    const there = new Set((route === undefined ? lab : own).map(({ file }) => file))
    const added = scriptsFrom(lazyOf(id), manifest, sizeOf).filter(({ file }) => !there.has(file))
    if (route !== undefined) sizes.push(sized(`page of ${id}`, own, budgets.page))
    if (added.length > 0) sizes.push(sized(`part of ${id}`, added, budget))
  }
  return sizes
}

function report() {
  for (const { what, files, bytes, budget } of measure()) {
    const line = `${what}: ${(bytes / kB).toFixed(1)} of ${budget / kB} kB in ${files.length} files`
    if (bytes <= budget) console.log(line)
    else {
      console.error(`${line}: too much. The largest:`)
      for (const file of files.slice(0, 8)) console.error(`  ${(file.bytes / kB).toFixed(1)} kB ${file.name}`)
      process.exitCode = 1
    }
  }
}

if (process.argv[1] === import.meta.filename) report()
