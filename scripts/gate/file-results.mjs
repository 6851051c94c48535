import { relative } from 'node:path'
import { house as repoRoot } from '../prepare/house.mjs'
import { openResults } from './results.mjs'

const outcomes = { passed: 'passed', failed: 'failed', skipped: 'skipped', pending: 'failed' }
const pathOf = (moduleId) => relative(repoRoot, moduleId).replaceAll('\\', '/')

/** @param {import('vitest/node').TestCase} test @returns {import('./results.mjs').Result} */
function resultOf(file, test) {
  const { state, errors = [] } = test.result()
  return {
    file,
    name: test.fullName,
    outcome: outcomes[state],
    seconds: (test.diagnostic()?.duration ?? 0) / 1000,
    ...(errors.length > 0 ? { failure: errors[0].message } : {}),
  }
}

/** Writes each test file's results as soon as it has ended (results.mjs). */
export default class FileResults {
  #results = openResults()

  /** @param {import('vitest/node').TestModule} module */
  onTestModuleEnd(module) {
    const file = pathOf(module.moduleId)
    const all = [...module.children.allTests()].map((test) => resultOf(file, test))
    for (const error of module.errors())
      all.push({ file, name: 'the file', outcome: 'failed', seconds: 0, failure: error.message })
    for (const result of all) this.#results.add(result)
    if (module.state() === 'passed' && all.length > 0) this.#results.complete(file, all)
  }

  /** Errors outside of any test, such as a rejected promise. @param {readonly Error[]} errors */
  onTestRunEnd(_modules, errors) {
    for (const { message } of errors)
      this.#results.add({
        file: '',
        name: 'outside of any test',
        outcome: 'failed',
        seconds: 0,
        failure: message,
      })
  }
}
