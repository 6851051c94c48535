// `npm run check:prose`: no file has more phrases of words.json than counts.json allows. `-- --write` saves lower counts.
// After a change of words.json, delete counts.json first: `--write` then counts all files again.
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { inHouse } from '../prepare/house.mjs'
import { compare, gone, likelyNew, toJson, uncounted, type Counts, type Found, type Worse } from './counts.ts'
import { originsOf } from './moves.ts'
import { lastTexts, linesOf, proseFiles, readFile } from './tree.ts'
import { matchesOf } from './words.ts'

const countsFile = inHouse('scripts', 'prose', 'counts.json')

const readCounts = () => JSON.parse(readFileSync(countsFile, 'utf8')) as Counts

/** Reads git only if a file may have been moved. */
function findOrigins(counts: Counts, found: readonly Found[]): Map<string, string> {
  const added = uncounted(counts, found)
  const deleted = gone(counts, found)
  if (added.length === 0 || deleted.length === 0) return new Map()
  return originsOf(
    new Map(added.map((path) => [path, linesOf(path, readFile(path))])),
    new Map([...lastTexts(deleted)].map(([path, text]) => [path, linesOf(path, text)])),
  )
}

function report({ path, matches, allowed }: Worse): string {
  const shown = likelyNew(matches, readFile(path), lastTexts([path]).get(path))
  const lines = shown.map(
    ({ line, phrase, better }) => `  ${path}:${line} "${phrase.replace(/\s+/g, ' ')}" → ${better}`,
  )
  return [`${path}: ${matches.length} phrases, ${allowed} allowed`, ...lines].join('\n')
}

function check(write: boolean): void {
  const found = proseFiles().map((path) => ({ path, matches: matchesOf(path, readFile(path)) }))
  const total = found.reduce((sum, { matches }) => sum + matches.length, 0)
  if (write && !existsSync(countsFile)) {
    writeFileSync(countsFile, toJson(compare({}, found).next))
    return console.log(`Prose: counted ${total} phrases.`)
  }
  const counts = readCounts()
  const { worse, better, next } = compare(counts, found, findOrigins(counts, found))
  if (worse.length > 0) {
    console.error(worse.map(report).join('\n'))
    console.error('Prose: reword these comments or documents; CONTRIBUTING.md, "How it is written".')
    process.exitCode = 1
  } else if (write) writeFileSync(countsFile, toJson(next))
  else if (better.length > 0)
    console.log(`Prose: fewer phrases in ${better.length} files; npm run check:prose -- --write saves that.`)
  console.log(`Prose: ${total} phrases in ${found.length} files, ${worse.length} files got worse.`)
}

check(process.argv.includes('--write'))
