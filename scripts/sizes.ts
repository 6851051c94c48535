// `npm run check:sizes`: the JavaScript that a page may load and that a feature may add to it, as brotli on the wire.
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { scriptsFrom, scriptsOf, type Asks, type Manifest, type Script } from './page-scripts.ts'
import { inHouse } from './prepare/house.mjs'

export interface Size {
  /** A page, or the lazy part of a feature: what it adds to its page. */
  readonly what: string
  readonly scripts: readonly Script[]
  /** Brotli bytes of all scripts, and how many there may be. */
  readonly bytes: number
  readonly budget: number
}

/** What a feature says of itself in its door. */
interface Feature {
  readonly id: string
  readonly route?: string
  /** Files of messages that it says. */
  readonly words: readonly string[]
  readonly budget: { readonly page?: number; readonly part?: number }
}

const web = inHouse('apps', 'web')
const kB = 1000
/** The language whose words are longest. */
const language = 'de'

const readJson = (...path: string[]) => JSON.parse(readFileSync(join(web, ...path), 'utf8')) as unknown

const featureOf = (source: string) => /^src\/features\/([^/]+)\//.exec(source)?.[1]
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

/** Everything that the lab may ask for, but parts and words of pages of their own, other languages and cards. */
const inLab =
  (card: string, pages: readonly string[], wordsOfPages: ReadonlySet<string>): Asks =>
  (source, { name = '' }) => {
    const [, locale, file = ''] = wordsOf(source) ?? /^(?:words)-(\w+)$/.exec(name) ?? []
    if (locale) return locale === language && !wordsOfPages.has(file)
    if (source.startsWith('content:card/')) return source === `content:card/${card}`
    return !pages.includes(featureOf(source) ?? '')
  }

/** Sizes of the present build. */
export function measure(): Size[] {
  const manifest = readJson('.svelte-kit', 'output', 'client', '.vite', 'manifest.json') as Manifest
  const features = readJson('build', 'prerendered', 'features.json') as Feature[]
  const htmlOf = (page: string) =>
    readFileSync(join(web, 'build', 'prerendered', `${page || 'index'}.html`), 'utf8')
  const sizeOf = (file: string) => readFileSync(join(web, 'build', 'client', `${file}.br`)).length
  const sized = (what: string, scripts: readonly Script[], budget: number): Size => {
    return { what, scripts, bytes: scripts.reduce((sum, { bytes }) => sum + bytes, 0), budget }
  }
  /** What `load` of a feature's door imports. */
  const lazyOf = (id: string) =>
    Object.keys(manifest).filter((source) => new RegExp(`^src/features/${id}/[^/]+$`).test(source))
  const card = 'friendship'
  const labOf = (asks: Asks) => scriptsOf(htmlOf(`lab/${card}`), manifest, sizeOf, asks)
  const lab = labOf(atOnce(card, ['editor']))
  const withPages = features.flatMap(({ id, route }) => (route === undefined ? [] : [id]))
  // The blocks are in the first load; what learns by trying is measured by its own part.
  const parts = features.filter(
    ({ id, route }) => route === undefined && id !== 'editor' && id !== 'q-learning',
  )
  const labBudget = 450 * kB
  const partsBudget = parts.reduce((sum, { budget }) => sum + (budget.part ?? 0), 0)
  const said = (all: readonly Feature[]) => new Set(all.flatMap(({ words }) => words))
  const inTheLab = said(features.filter(({ route }) => route === undefined))
  const saidByPages = said(features.filter(({ route }) => route !== undefined))
  const wordsOfPages = new Set([...saidByPages].filter((file) => !inTheLab.has(file)))
  const pages = [
    sized('lab', lab, labBudget),
    sized(
      'lab, all of it',
      labOf(inLab(card, [...withPages, 'q-learning'], wordsOfPages)),
      labBudget + partsBudget,
    ),
  ]
  for (const { id, route, budget } of features) {
    const own = route === undefined ? [] : scriptsOf(htmlOf(route), manifest, sizeOf, atOnce(null, []))
    const there = new Set((route === undefined ? lab : own).map(({ file }) => file))
    const part = scriptsFrom(lazyOf(id), manifest, sizeOf)
    const added = part.filter(({ file }) => !there.has(file))
    // A page whose `load` asks for its lazy part fetches it at once: both budgets are the page's then.
    const isAtOnce = part.length > 0 && added.length === 0
    const { page = 0, part: more = 0 } = budget
    if (page) pages.push(sized(`page of ${id}`, own, page + (isAtOnce ? more : 0)))
    if (more && !isAtOnce) pages.push(sized(`part of ${id}`, added, more))
  }
  return pages
}

function report() {
  for (const { what, scripts, bytes, budget } of measure()) {
    const line = `${what}: ${(bytes / kB).toFixed(1)} of ${budget / kB} kB brotli JavaScript in ${scripts.length} files`
    if (bytes <= budget) console.log(line)
    else {
      console.error(`${line}: too much. The largest:`)
      for (const script of scripts.slice(0, 8))
        console.error(`  ${(script.bytes / kB).toFixed(1)} kB ${script.name}`)
      process.exitCode = 1
    }
  }
}

if (process.argv[1] === import.meta.filename) report()
