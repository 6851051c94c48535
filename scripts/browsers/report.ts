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
  /** APIs that a promised browser lacks and that are not handled. */
  readonly lacking: readonly (Row & { readonly missing: string })[]
  /** APIs that a promised browser lacks, each with the behaviour without it. */
  readonly handled: readonly (Row & { readonly instead: string })[]
  /** Entries of `handled` that are not used, or that no promised browser lacks. */
  readonly unused: readonly string[]
  /** The newest APIs that all promised browsers have. */
  readonly newest: readonly Row[]
}

type Promised = { readonly [browser: string]: string }

/** The entry of a use with the fewest browsers that lack it. */
function bestOf({ paths }: Use, promised: Promised) {
  const entries = paths.map((path) => entryAt(path)!)
  return entries
    .map((entry) => ({ entry, missing: missingIn(entry, promised) }))
    .toSorted((a, b) => a.missing.length - b.missing.length)[0]
}

/** @param handled by name, the behaviour of the lab without the API */
export function reportOf(
  uses: readonly Use[],
  promised: Promised,
  handled: { readonly [name: string]: string },
): Report {
  const known = uses.flatMap((use) => {
    const best = bestOf(use, promised)
    return best ? [{ ...best, name: use.name, places: use.places, versions: versionsOf(best.entry) }] : []
  })
  const rowOf = ({ name, versions, places }: Row): Row => ({ name, versions, places })
  const lacks = known.filter(({ missing }) => missing.length > 0)
  return {
    lacking: lacks
      .filter(({ name }) => !Object.hasOwn(handled, name))
      .map((one) => ({
        ...rowOf(one),
        missing: one.missing
          .map(({ browser, since }) => `${browser} ${since ? `before ${since}` : 'at all'}`)
          .join(', '),
      })),
    handled: lacks
      .filter(({ name }) => Object.hasOwn(handled, name))
      .map((one) => ({ ...rowOf(one), instead: handled[one.name]! })),
    unused: Object.keys(handled).filter((name) => !lacks.some((one) => one.name === name)),
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

/** The report as a page of the docs. */
export function pageOf({ handled, newest }: Report, promised: Promised): string {
  const names = { safari: 'Safari', firefox: 'Firefox', chrome: 'Chrome', edge: 'Edge' } as const
  const versions = Object.entries(promised).map(
    ([name, version]) => `${names[name as keyof typeof names]} ${version}`,
  )
  const head = '| API | Safari | Firefox | Chrome |\n| --- | --- | --- | --- |'
  return `# Browsers

Our scripts are written for ${versions.join(', ')} and newer, Safari on an iPad too. The build, lint and this page take the
versions from \`packages/browsers/promised.ts\`. Styles and libraries are not compared with them yet, and the oldest versions themselves
have not been tried.

\`npm run check:browsers -- --write\` makes this page: TypeScript's checker finds the APIs that our own scripts use, and MDN's table of
compatibility (\`@mdn/browser-compat-data\`) lists the versions that have them.

## Newer than promised

| API | Safari | Firefox | Chrome | without it |
| --- | --- | --- | --- | --- |
${handled.map(({ name, versions, instead }) => `| \`${name}\` | ${versions.join(' | ')} | ${instead} |`).join('\n')}

## The newest that all promised browsers have

${head}
${newest.map(cells).join('\n')}
`
}
