import { entryAt, missingIn, versionsOf } from './support.mjs'
import type { Use } from './uses.ts'

/** An API that is newer than one of the promised browsers, or as new as one. */
interface Row {
  readonly name: string
  /** First versions of Safari, Firefox and Chrome. */
  readonly versions: readonly string[]
  readonly places: readonly string[]
}

export interface Report {
  /** APIs that a promised browser lacks and that no list names. */
  readonly lacking: readonly (Row & { readonly missing: string })[]
  /** APIs that a promised browser lacks, each with the behaviour without it. */
  readonly handled: readonly (Row & { readonly instead: string })[]
  /** APIs that a promised browser lacks and whose lack is a fault, each with the fault. */
  readonly faults: readonly (Row & { readonly instead: string })[]
  /** Entries of the lists that are not used, or that no promised browser lacks. */
  readonly unused: readonly string[]
  /** The newest APIs that all promised browsers have. */
  readonly newest: readonly Row[]
}

type Promised = { readonly [browser: string]: string }

/** Lists by name of APIs that a promised browser lacks. */
export interface Lists {
  /** The behaviour of the lab without each of them. */
  readonly handled: { readonly [name: string]: string }
  /** The fault that a user sees without each of them. */
  readonly faults: { readonly [name: string]: string }
}

function missingAt(path: string, promised: Promised) {
  const missing = missingIn(entryAt(path)!, promised, path.startsWith('css.'))
  // A value that is as old as its property is reported with the property.
  const [, property] = /^(css\.properties\.[^.]+)\.[^.]+$/.exec(path) ?? []
  const ofProperty = property === undefined ? [] : missingIn(entryAt(property)!, promised)
  return missing.filter(
    ({ browser, since }) => !ofProperty.some((one) => one.browser === browser && one.since === since),
  )
}

/** The entry of a use with the fewest browsers that lack it. */
function bestOf({ paths }: Use, promised: Promised) {
  return paths
    .map((path) => ({ entry: entryAt(path)!, missing: missingAt(path, promised) }))
    .toSorted((a, b) => a.missing.length - b.missing.length)[0]
}

export function reportOf(uses: readonly Use[], promised: Promised, { handled, faults }: Lists): Report {
  const known = uses.flatMap((use) => {
    const best = bestOf(use, promised)
    return best ? [{ ...best, name: use.name, places: use.places, versions: versionsOf(best.entry) }] : []
  })
  const rowOf = ({ name, versions, places }: Row): Row => ({ name, versions, places })
  const lacks = known.filter(({ missing }) => missing.length > 0)
  const listed = (list: Lists['handled']) =>
    lacks
      .filter(({ name }) => Object.hasOwn(list, name))
      .map((one) => ({ ...rowOf(one), instead: list[one.name]! }))
  const named = [...Object.keys(handled), ...Object.keys(faults)]
  return {
    lacking: lacks
      .filter(({ name }) => !named.includes(name))
      .map((one) => ({
        ...rowOf(one),
        missing: one.missing
          .map(({ browser, since }) => `${browser} ${since ? `before ${since}` : 'at all'}`)
          .join(', '),
      })),
    ...{ handled: listed(handled), faults: listed(faults) },
    unused: named.filter((name) => !lacks.some((one) => one.name === name)),
    newest: known.filter(({ missing, versions }) => missing.length === 0 && isNew(versions)).map(rowOf),
  }
}

/** Is an entry of the table newer than a promised browser, or so new that the page lists it? */
export const isOfInterest = (entry: object, promised: Promised): boolean =>
  missingIn(entry, promised).length > 0 || isNew(versionsOf(entry))

/** Younger than Safari 14, Firefox 90 or Chrome 90: older APIs need no row. */
const isNew = (versions: readonly string[]) =>
  versions.some((version, at) => parseFloat(version.replace('≤', '')) > [14, 90, 90][at]!)

const cells = ({ name, versions }: Row) => `| \`${name}\` | ${versions.join(' | ')} |`

const tableOf = (rows: Report['handled'], last: string) =>
  [
    `| API | Safari | Firefox | Chrome | ${last} |`,
    '| --- | --- | --- | --- | --- |',
    ...rows.map(({ name, versions, instead }) => `| \`${name}\` | ${versions.join(' | ')} | ${instead} |`),
  ].join('\n')

/** The report as a page of the docs. */
export function pageOf({ handled, faults, newest }: Report, promised: Promised): string {
  const names = { safari: 'Safari', firefox: 'Firefox', chrome: 'Chrome', edge: 'Edge' } as const
  const versions = Object.entries(promised).map(
    ([name, version]) => `${names[name as keyof typeof names]} ${version}`,
  )
  const head = '| API | Safari | Firefox | Chrome |\n| --- | --- | --- | --- |'
  return `# Browsers

Our scripts are written for ${versions.join(', ')} and newer, Safari on an iPad too. The build, lint and this page take the
versions from \`packages/browsers/promised.ts\`. Libraries are not compared with them, and the oldest versions themselves have not
been tried.

\`npm run check:browsers -- --write\` makes this page: TypeScript's checker finds the APIs that our own scripts use, PostCSS the features of our
styles, and MDN's table of compatibility (\`@mdn/browser-compat-data\`) lists the versions that have them.

## Faults in promised browsers

${tableOf(faults, 'fault without it')}

## Newer than promised

${tableOf(handled, 'without it')}

## The newest that all promised browsers have

${head}
${newest.map(cells).join('\n')}
`
}
