import { appendFileSync, existsSync, readFileSync } from 'node:fs'
import { addRecord } from './records.mjs'

/**
 * One finished test of a file: `passed`, `failed`, `flaky` (passed at a further try) or `skipped`, with its first failure and
 * files with the roles and names on the browser's page at that moment.
 * @typedef {{ file: string, name: string, outcome: 'passed' | 'failed' | 'flaky' | 'skipped', seconds: number, failure?: string, pages?: string[] }} Result
 */

/** Environment variables by which a step configures the reporters in the processes of Vitest and Playwright. */
const environment = {
  results: 'BOTGARTEN_RESULTS',
  keys: 'BOTGARTEN_KEYS',
  records: 'BOTGARTEN_GREEN',
  run: 'BOTGARTEN_RUN',
}

/**
 * @param {{ results: string, keys: string, records: string | null, run: string }} options paths of the file for results, of the
 * keys of test files as JSON and of the records; the name of this run
 */
export const reporterEnvironment = ({ results, keys, records, run }) => ({
  ...{ [environment.results]: results, [environment.keys]: keys, [environment.run]: run },
  ...(records === null ? {} : { [environment.records]: records }),
})

/**
 * For a reporter: appends each result, and a record once all tests of a file are good. Does nothing in a run that no step has
 * started.
 */
export function openResults() {
  const { [environment.results]: results, [environment.keys]: keys } = process.env
  const records = process.env[environment.records] ?? null
  const keyOf = keys === undefined ? {} : JSON.parse(readFileSync(keys, 'utf8'))
  const run = process.env[environment.run] ?? ''
  return {
    /** @param {Result} result */
    add(result) {
      if (results !== undefined) appendFileSync(results, `${JSON.stringify(result)}\n`)
    },
    /** All tests of a file have ended. @param {string} file @param {readonly Result[]} all */
    complete(file, all) {
      const key = keyOf[file]
      if (key === undefined || !all.every(isGood)) return
      const flaky = all
        .filter(({ outcome }) => outcome === 'flaky')
        .map(({ name, failure = '' }) => ({ name: `${file} › ${name}`, failure }))
      addRecord(records, { key, run, passed: all.length, flaky })
    },
  }
}

/** A flaky test counts as passed; a skipped one has shown nothing. @param {Result} result */
export const isGood = ({ outcome }) => outcome === 'passed' || outcome === 'flaky'

/** @param {string} file @returns {Result[]} */
export const readResults = (file) =>
  existsSync(file)
    ? readFileSync(file, 'utf8')
        .split('\n')
        .filter(Boolean)
        .map((line) => JSON.parse(line))
    : []
