import { mkdirSync, writeFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { inHouse as inRepo } from '../prepare/house.mjs'

/** This number of flaky tests in one run, all shards added up, is a fault of the tests. */
const TOO_MANY_FLAKY = 3

/** @param {readonly { name: string }[]} flaky each test once */
export const isTooFlaky = (flaky) => flaky.length >= TOO_MANY_FLAKY

/** @param {readonly import('./records.mjs').Flaky[]} flaky */
const distinct = (flaky) => [...new Map(flaky.map((one) => [one.name, one])).values()]

function writeFlaky(flaky) {
  const file = inRepo('test-results', 'flaky.json')
  mkdirSync(dirname(file), { recursive: true })
  writeFileSync(file, `${JSON.stringify(flaky, null, 2)}\n`)
}

/** Lists the tests that needed a further try. */
function listFlaky(flaky) {
  for (const { name, failure } of flaky) console.log(`\nflaky: ${name}\n${failure}`)
  if (isTooFlaky(flaky))
    console.log(
      `\n${TOO_MANY_FLAKY} flaky tests or more: this run has failed. \`--fresh\` runs everything again.`,
    )
}

/**
 * Prints the outcome of a run; the last line holds the counts alone.
 * @param {readonly { passed: number, failed: number, flaky?: import('./records.mjs').Flaky[], known?: number }[]} outcomes
 * @param {number} began in ms
 * @param {readonly import('./records.mjs').Flaky[]} [earlier] flaky tests in other shards of this run
 * @param {(flaky: import('./records.mjs').Flaky[]) => void} [write] where flaky tests are written: test-results/flaky.json
 * @returns {number} the exit code
 */
export function summarize(outcomes, began, earlier = [], write = writeFlaky) {
  const sum = (what) => outcomes.reduce((total, outcome) => total + (outcome[what] ?? 0), 0)
  const flaky = distinct([...earlier, ...outcomes.flatMap((outcome) => outcome.flaky ?? [])])
  write(flaky)
  listFlaky(flaky)
  const failed = sum('failed') + (isTooFlaky(flaky) ? 1 : 0)
  const known = sum('known')
  console.log(`\n${Math.round((Date.now() - began) / 1000)} s`)
  if (known > 0)
    console.log(`${known} of the passed ones were green before; no file that decides about them has changed.`)
  if (flaky.length > 0) console.log(`${flaky.length} flaky, in all shards of this run.`)
  console.log(`${sum('passed')} passed, ${failed} failed`)
  return failed === 0 ? 0 : 1
}
