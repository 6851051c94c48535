// `npm run check:sizes`: the JavaScript that a page may load, as brotli on the wire.
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { scriptsOf } from './page-scripts.ts'
import type { Manifest, Script } from './page-scripts.ts'
import { inHouse } from './prepare/house.mjs'

export interface PageSize {
  readonly page: string
  readonly scripts: readonly Script[]
  /** Brotli bytes of all scripts, and how many the page may have. */
  readonly bytes: number
  readonly budget: number
}

const web = inHouse('apps', 'web')
const kB = 1000

const budgets = [
  { page: 'home', file: 'index.html', budget: 100 * kB },
  { page: 'lab', file: 'lab/friendship.html', budget: 450 * kB, content: 'friendship' },
  {
    page: 'lab, all of it',
    file: 'lab/friendship.html',
    budget: 600 * kB,
    content: 'friendship',
    playground: 'neural-network',
    withLater: true,
  },
]

/** Pages of the present build, in the language whose words are longest. */
export function measurePages(): PageSize[] {
  const manifestFile = join(web, '.svelte-kit', 'output', 'client', '.vite', 'manifest.json')
  const manifest = JSON.parse(readFileSync(manifestFile, 'utf8')) as Manifest
  return budgets.map(({ page, file, budget, ...counted }) => {
    const html = readFileSync(join(web, 'build', 'prerendered', file), 'utf8')
    const scripts = scriptsOf(
      html,
      manifest,
      (script) => readFileSync(join(web, 'build', 'client', `${script}.br`)).length,
      { language: 'de', ...counted },
    )
    return { page, scripts, bytes: scripts.reduce((sum, { bytes }) => sum + bytes, 0), budget }
  })
}

function report() {
  for (const { page, scripts, bytes, budget } of measurePages()) {
    const line = `${page}: ${(bytes / kB).toFixed(1)} of ${budget / kB} kB brotli JavaScript in ${scripts.length} files`
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
