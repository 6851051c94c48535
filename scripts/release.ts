// `npm run release -- 0.2.0`: sets the version everywhere, once the sentences compiled by Paraglide have been made again and
// are the committed ones. It commits nothing, so that the changes can be reviewed first.
import { execFileSync } from 'node:child_process'
import { globSync, readFileSync } from 'node:fs'
import { writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { inHouse } from './prepare/house.mjs'
import { asScript, run, Trouble } from './prepare/run.mjs'

interface Versioned {
  version: string
}
interface LockFile extends Versioned {
  packages: { readonly [folder: string]: Versioned }
}

const manifests = ['package.json', 'content/package.json', '{packages,apps}/*/package.json']
const others = ['e2e/package.json', 'benchmarks/package.json', 'package-lock.json', 'CHANGELOG.md']

/** The files that hold the version, by their paths below this folder. */
export function versionFiles(folder: string): Map<string, string> {
  const paths = globSync([...manifests, ...others], { cwd: folder }).sort()
  return new Map(paths.map((path) => [path.replaceAll('\\', '/'), readFileSync(join(folder, path), 'utf8')]))
}

/**
 * These files as they are with a new version; the root's package.json says which one they have now.
 * @param date as in the CHANGELOG: 2026-11-22
 * @throws Trouble for a version that is none or is not newer, and where nothing is left to be released
 */
export function released(
  files: ReadonlyMap<string, string>,
  version: string,
  date: string,
): Map<string, string> {
  const { version: now } = JSON.parse(files.get('package.json')!) as Versioned
  if (!isNewer(version, now))
    throw new Trouble(
      `The version is ${now}; a release needs a newer one such as ${next(now)}, not ${version}.`,
    )
  return new Map(
    [...files].map(([path, text]) => {
      if (path === 'CHANGELOG.md') return [path, withHeading(text, version, date)]
      if (path === 'package-lock.json') return [path, lockedAt(text, version)]
      return [path, asFile({ ...(JSON.parse(text) as Versioned), version })]
    }),
  )
}

const numbersIn = (version: string) => /^(\d+)\.(\d+)\.(\d+)$/.exec(version)?.slice(1).map(Number)

const next = (version: string) => {
  const [major = 0, minor = 0] = numbersIn(version) ?? []
  return `${major}.${minor + 1}.0`
}

function isNewer(version: string, than: string): boolean {
  const [wanted, present] = [numbersIn(version), numbersIn(than)]
  if (!wanted || !present) return false
  const differs = wanted.findIndex((number, at) => number !== present[at])
  return differs >= 0 && wanted[differs]! > present[differs]!
}

function withHeading(text: string, version: string, date: string): string {
  const heading = '## [Unreleased]\n'
  const [, rest = ''] = text.split(heading)
  if (!/^\s*(?!## )\S/.test(rest))
    throw new Trouble('CHANGELOG.md has nothing under "Unreleased": write there first what is new.')
  return text.replace(heading, `${heading}\n## [${version}] - ${date}\n`)
}

/** Workspaces lie in the lock file under their folders; everything else comes from the registry. */
function lockedAt(text: string, version: string): string {
  const lock = JSON.parse(text) as LockFile
  const isOurs = (folder: string) => !/(^|\/)node_modules\//.test(folder)
  const packages = Object.fromEntries(
    Object.entries(lock.packages).map(([folder, one]) => [
      folder,
      isOurs(folder) ? { ...one, version } : one,
    ]),
  )
  return asFile({ ...lock, version, packages })
}

const asFile = (data: object) => `${JSON.stringify(data, null, 2)}\n`

function refuseDirty(): void {
  const changed = execFileSync('git', ['status', '--porcelain'], { cwd: inHouse('.'), encoding: 'utf8' })
  if (changed !== '') throw new Trouble(`There are changes that are not committed:\n${changed.trimEnd()}`)
}

if (import.meta.main)
  await asScript(async () => {
    const [version = ''] = process.argv.slice(2)
    refuseDirty()
    if ((await run(process.execPath, [inHouse('scripts/paraglide.ts'), '--check'])) !== 0) return 1
    const today = new Date().toISOString().slice(0, 10)
    for (const [path, text] of released(versionFiles(inHouse('.')), version, today))
      await writeFile(inHouse(path), text)
    console.log(`Everything says ${version} now. Look at it with git diff, then commit it.`)
    return 0
  })
