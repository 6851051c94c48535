import { relative } from 'node:path'
import { stripVTControlCharacters } from 'node:util'
import { house as repoRoot } from '../scripts/prepare/house.mjs'
import { openResults } from '../scripts/gate/results.mjs'

const outcomes = { expected: 'passed', unexpected: 'failed', flaky: 'flaky', skipped: 'skipped' }
const pathOf = (file) => relative(repoRoot, file).replaceAll('\\', '/')
const plain = (text = '') => stripVTControlCharacters(text)

/** Will Playwright try this test once more? @param {import('@playwright/test/reporter').TestCase} test */
const isTriedAgain = (test, result) => test.outcome() === 'unexpected' && result.retry < test.retries

/** @param {import('@playwright/test/reporter').TestCase} test @returns {import('../scripts/gate/results.mjs').Result} */
function resultOf(test) {
  const failed = test.results.find(({ error }) => error !== undefined)
  return {
    file: pathOf(test.location.file),
    name: test.titlePath().slice(3).join(' › '),
    outcome: outcomes[test.outcome()],
    seconds: test.results.reduce((sum, { duration }) => sum + duration, 0) / 1000,
    ...(failed ? { failure: plain(failed.error.message), pages: pagesOf(test) } : {}),
  }
}

/** Files with the roles and names on the page at the moment of the failure. */
const pagesOf = ({ results }) =>
  results.flatMap(({ attachments }) =>
    attachments.flatMap(({ name, path }) => (name === 'error-context' && path ? [path] : [])),
  )

/** Writes each test's result, and a record once all tests of a file are green (scripts/gate/results.mjs). */
export default class FileResults {
  #results = openResults()
  /** Tests that have not ended yet, by file. */
  #left = new Map()
  #ended = new Map()

  /** @param {import('@playwright/test/reporter').Suite} suite */
  onBegin(_config, suite) {
    for (const test of suite.allTests()) {
      const file = pathOf(test.location.file)
      this.#left.set(file, (this.#left.get(file) ?? 0) + 1)
    }
  }

  onTestEnd(test, result) {
    if (isTriedAgain(test, result)) return
    const ended = resultOf(test)
    const all = [...(this.#ended.get(ended.file) ?? []), ended]
    this.#results.add(ended)
    this.#ended.set(ended.file, all)
    const left = this.#left.get(ended.file) - 1
    this.#left.set(ended.file, left)
    if (left === 0) this.#results.complete(ended.file, all)
  }

  /** Errors outside of any test, such as a file that does not compile. */
  onError(error) {
    const failure = plain(error.message ?? error.value)
    this.#results.add({ file: '', name: 'outside of any test', outcome: 'failed', seconds: 0, failure })
  }

  printsToStdio() {
    return false
  }
}
