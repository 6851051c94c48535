import { createHash } from 'node:crypto'
import { appendFileSync, existsSync, mkdirSync, readFileSync, realpathSync, statSync } from 'node:fs'
import { homedir } from 'node:os'
import { dirname, join } from 'node:path'
import { house as repoRoot } from '../prepare/house.mjs'

/**
 * The record of a green test file or check. `key` is a hash of everything that decides its outcome; `run` names the run whose
 * shards are added up; `flaky` holds the tests that needed a further try, each with its first failure.
 * @typedef {{ name: string, failure: string }} Flaky
 * @typedef {{ key: string, run?: string, passed: number, flaky: Flaky[] }} Green
 */

const cacheRoot = () => process.env['XDG_CACHE_HOME'] || join(homedir(), '.cache')

/** Names this clone: another clone, even a later one at the same path, is another one. */
function nameOfClone() {
  const git = join(repoRoot, '.git')
  if (!existsSync(git)) return null
  const { birthtimeMs, ino } = statSync(git)
  return createHash('sha256')
    .update([realpathSync(repoRoot), birthtimeMs, ino].join('\n'))
    .digest('hex')
    .slice(0, 16)
}

/**
 * The file with the records of this clone, in the user's cache folder and so outside of the repository: a fresh clone starts
 * without records and runs everything. Null without git.
 */
export function recordsFile() {
  const name = nameOfClone()
  return name === null ? null : join(cacheRoot(), 'botgarten', name, 'green.jsonl')
}

/** A line that was cut off by a killed process is no record. @param {string} line */
function parse(line) {
  try {
    return [JSON.parse(line)]
  } catch {
    return []
  }
}

/**
 * Records of green test files and checks, by key, without those of runs that were started again with `--fresh`.
 * @param {string | null} file
 * @returns {Map<string, Green>}
 */
export function readRecords(file) {
  const greens = new Map()
  if (file === null || !existsSync(file)) return greens
  for (const line of readFileSync(file, 'utf8').split('\n').flatMap(parse)) {
    if (typeof line.key === 'string') greens.set(line.key, line)
    else for (const [key, { run }] of greens) if (run === line.fresh) greens.delete(key)
  }
  return greens
}

/** Appends a line at once, so that a killed run can resume. @param {string | null} file */
function append(file, line) {
  if (file === null) return
  mkdirSync(dirname(file), { recursive: true })
  appendFileSync(file, `${JSON.stringify(line)}\n`)
}

/** @param {string | null} file @param {Green} green */
export const addRecord = (file, green) => append(file, green)

/** Discards the records of a run, which starts again. @param {string | null} file @param {string} run */
export const forgetRun = (file, run) => append(file, { fresh: run })

/** Flaky tests of all shards of a run. @param {string | null} file @param {string} run @returns {Flaky[]} */
export const flakyOf = (file, run) =>
  [...readRecords(file).values()].filter((green) => green.run === run).flatMap(({ flaky }) => flaky)
