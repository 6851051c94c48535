// `npm run check:browsers`: fails if a script or a style uses an API that a promised browser lacks and no list names, and if
// docs/browsers.md is out of date; with `-- --write` it writes the file. It reads the scripts of components as svelte-check
// writes them for TypeScript.
import { globSync, readFileSync, writeFileSync } from 'node:fs'
import { parseArgs } from 'node:util'
import { format, resolveConfig } from 'prettier'
import { promised } from '../../packages/browsers/promised.ts'
import { inHouse } from '../prepare/house.mjs'
import { asScript, npmAside, Trouble } from '../prepare/run.mjs'
import { isOfInterest, pageOf, reportOf } from './report.ts'
import { stylesIn } from './styles.ts'
import { entryAt, table } from './support.mjs'
import { Lookup, usesIn } from './uses.ts'

/** Scripts of pages and workers, and the packages that they import. */
const rooms =
  /^(apps\/web\/(src|\.svelte-kit\/\.svelte-check\/svelte\/src)|packages\/(browsers|numbers|learning|simulation|blocks|programs|lab|maps|experiments|content|answers|messages))\//
const elsewhere = /node_modules|\.test\.ts$|\/testing\/|\+server\.ts$|hooks\.server/

const readList = (name: string) =>
  JSON.parse(readFileSync(inHouse(`scripts/browsers/${name}.json`), 'utf8')) as {
    readonly [name: string]: string
  }

await asScript(async () => {
  const { values } = parseArgs({ options: { write: { type: 'boolean', default: false } } })
  const { code, said } = await npmAside(['run', '--silent', 'types:web'])
  if (code !== 0) throw new Trouble(said)
  const lookup = new Lookup(table, (path) => entryAt(path)?.['__compat'] !== undefined)
  const uses = usesIn(inHouse('apps/web/.svelte-kit/.svelte-check/tsconfig.json'), {
    isOurs: (file) => rooms.test(file) && !elsewhere.test(file),
    ...{ house: inHouse('.'), lookup },
    names: lookup.namesWhere((entry) => isOfInterest(entry, promised)),
  })
  const sheets = globSync('apps/web/src/**/*.{css,svelte}', { cwd: inHouse('.') }).map((file) => ({
    ...{ file: file.replaceAll('\\', '/'), text: readFileSync(inHouse(file), 'utf8') },
  }))
  const report = reportOf([...uses, ...stylesIn(sheets)], promised, {
    ...{ handled: readList('handled'), faults: readList('faults') },
  })
  const file = inHouse('docs/browsers.md')
  const page = await format(pageOf(report, promised), { ...(await resolveConfig(file)), parser: 'markdown' })
  if (values.write) writeFileSync(file, page)
  for (const { name, missing, places } of report.lacking)
    console.error(`${name}: ${missing}. Used in ${places.join(', ')}`)
  for (const name of report.unused)
    console.error(`${name} in handled.json or faults.json is not used, or no browser lacks it.`)
  const isCurrent = readFileSync(file, 'utf8') === page
  if (!isCurrent) console.error('docs/browsers.md is out of date: npm run check:browsers -- --write')
  return report.lacking.length + report.unused.length === 0 && isCurrent ? 0 : 1
})
