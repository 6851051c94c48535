import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { inHouse as inRepo } from '../prepare/house.mjs'
import { npm } from '../prepare/run.mjs'
import { isGood, readResults, reporterEnvironment } from './results.mjs'

/**
 * Test files that one command runs. `keyOf` gives a hash of everything that decides how a file ends, null if nothing is
 * recorded.
 * @typedef {object} Suite
 * @property {string} name
 * @property {string} script the npm script
 * @property {readonly string[]} args
 * @property {boolean} isPart may the command leave out some of the files, as a shard or a sample does?
 * @property {NodeJS.ProcessEnv} [env]
 * @property {readonly string[]} files paths relative to the repository
 * @property {(file: string) => string | null} keyOf
 * @property {(files: readonly string[], folder: string) => { args?: readonly string[], env?: NodeJS.ProcessEnv }} choose arguments
 * and environment that name the files to run; `folder` is a temporary folder
 *
 * @typedef {object} Context
 * @property {ReadonlyMap<string, import('./records.mjs').Green>} greens records by key
 * @property {string | null} records the file to which more is appended
 * @property {string} run the name under which the shards of one run are added up
 * @property {NodeJS.ProcessEnv} environment
 *
 * @typedef {{ passed: number, failed: number, flaky: import('./records.mjs').Flaky[], known: number, results: import('./results.mjs').Result[] }} Outcome
 */

/** A page may be long; its first lines show where the child was. */
const mostOfAPage = 6000

/** @param {import('./results.mjs').Result} result */
function show({ file, name, failure = '', pages = [] }) {
  console.log(`\n!! ${file} › ${name}\n${failure}`)
  for (const page of pages) console.log(readFileSync(page, 'utf8').slice(0, mostOfAPage))
}

/** @param {readonly import('./results.mjs').Result[]} results @param {boolean} hasFailed the command's own verdict */
function count(results, hasFailed) {
  const passed = results.filter(isGood).length
  const failed = results.length - passed
  return { passed, failed: hasFailed ? Math.max(failed, 1) : failed }
}

const flakyIn = (results) =>
  results
    .filter(({ outcome }) => outcome === 'flaky')
    .map(({ file, name, failure = '' }) => ({ name: `${file} › ${name}`, failure }))

/** A file of which nothing was heard has shown nothing. @returns {import('./results.mjs').Result[]} */
const missingIn = (results, files) =>
  files
    .filter((file) => !results.some((result) => result.file === file))
    .map((file) => ({ file, name: 'no test ran', outcome: 'failed', seconds: 0 }))

/** Runs the command for some files. @param {Suite} suite @returns {Promise<Omit<Outcome, 'known'>>} */
async function runFiles(suite, files, { records, run, environment }) {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-suite-'))
  try {
    const [results, keys] = [join(folder, 'results.jsonl'), join(folder, 'keys.json')]
    const keyed = files.map((file) => [file, suite.keyOf(file)]).filter(([, key]) => key !== null)
    writeFileSync(keys, JSON.stringify(Object.fromEntries(keyed)))
    const { args = [], env = {} } = suite.choose(files, folder)
    const code = await npm(['run', '--silent', suite.script, '--', ...suite.args, ...args], {
      env: {
        ...{ ...process.env, ...environment, ...suite.env, ...env },
        ...reporterEnvironment({ results, keys, records, run }),
      },
    })
    const found = [...readResults(results)]
    if (!suite.isPart) found.push(...missingIn(found, files))
    for (const result of found) if (!isGood(result)) show(result)
    return { ...count(found, code !== 0), flaky: flakyIn(found), results: found }
  } finally {
    rmSync(folder, { recursive: true, force: true })
  }
}

/**
 * Runs the files of a suite that have no record of being green in their present state.
 * @param {Suite} suite
 * @param {Context} context
 * @returns {Promise<Outcome>} with the tests that were green before; `known` is their number
 */
export async function runSuite(suite, context) {
  const began = Date.now()
  console.log(`\n── ${suite.name} (npm run ${suite.script})`)
  const greenOf = (file) => context.greens.get(suite.keyOf(file) ?? '')
  const known = suite.files.map(greenOf).filter((green) => green !== undefined)
  const files = suite.files.filter((file) => greenOf(file) === undefined)
  const ran =
    files.length > 0
      ? await runFiles(suite, files, context)
      : { passed: 0, failed: 0, flaky: [], results: [] }
  const before = known.reduce((sum, { passed }) => sum + passed, 0)
  const verdict = ran.failed === 0 ? 'good' : 'FAILED'
  console.log(
    `── ${suite.name}: ${verdict} (${Math.round((Date.now() - began) / 1000)} s, ${files.length} of ${suite.files.length} files)`,
  )
  return {
    ...ran,
    passed: ran.passed + before,
    flaky: [...known.flatMap(({ flaky }) => flaky), ...ran.flaky],
    known: before,
  }
}

/** Unit tests, by Vitest. @param {Pick<Suite, 'files' | 'keyOf'> & { name?: string, shard?: string | null }} options @returns {Suite} */
export const unitSuite = ({ name = 'unit tests', files, keyOf, shard = null }) => ({
  ...{ name, script: 'test:unit', files, keyOf, isPart: shard !== null },
  args: [
    ...['--reporter=dot', `--reporter=${inRepo('scripts', 'gate', 'file-results.mjs')}`],
    ...(shard === null ? [] : [`--shard=${shard}`, '--passWithNoTests']),
  ],
  choose(chosen, folder) {
    const list = join(folder, 'files.txt')
    writeFileSync(list, chosen.join('\n'))
    return { env: { BOTGARTEN_TEST_FILES: list } }
  },
})

/**
 * Browser tests, by Playwright.
 * @param {Pick<Suite, 'name' | 'script' | 'files' | 'keyOf'> & { shard?: string | null, isPart?: boolean }} options
 * @returns {Suite}
 */
export const browserSuite = ({ name, script, files, keyOf, shard = null, isPart = shard !== null }) => ({
  ...{ name, script, files, keyOf, isPart },
  args: [
    `--reporter=list,${inRepo('e2e', 'file-results.mjs')}`,
    ...(shard === null ? [] : [`--shard=${shard}`, '--pass-with-no-tests']),
  ],
  choose: (chosen) => ({ args: chosen.map((file) => file.replace(/^e2e\//, '')) }),
})
