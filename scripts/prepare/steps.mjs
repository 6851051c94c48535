import { readFileSync } from 'node:fs'
import { countOfPlaywright, countOfVitest, failedIn, oneStep } from './counts.mjs'
import { npm, npmAside } from './run.mjs'

/**
 * One npm script, and how its tests are counted.
 * @typedef {{ name: string, script: string, args?: string[], env?: object, count?: (failed: boolean) => { passed: number, failed: number } }} Step
 */

/** What a page held may be long; its first lines tell where the child was. */
const mostOfAPage = 6000

/** Counts the browser tests, and shows what the pages of those held that failed. */
function countBrowserTests(file) {
  const report = readJson(file)
  for (const { title, pages } of failedIn(report)) {
    console.log(`\n!! ${title}`)
    for (const page of pages) console.log(readFileSync(page, 'utf8').slice(0, mostOfAPage))
  }
  return countOfPlaywright(report)
}

const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'))

/** What a step counted; a step that cannot be counted is one failure. */
function countOf({ count = oneStep }, failed) {
  try {
    const counted = count(failed)
    return failed && counted.failed === 0 ? { ...counted, failed: 1 } : counted
  } catch (cause) {
    console.error(cause)
    return oneStep(true)
  }
}

export const good = ({ failed }) => failed === 0

/** Runs one step. `aside`: what it says is shown as a whole at its end. */
export async function take(step, environment, aside = false) {
  const began = Date.now()
  const title = `\n── ${step.name} (npm run ${step.script})`
  if (!aside) console.log(title)
  const args = ['run', '--silent', step.script, ...(step.args ? ['--', ...step.args] : [])]
  const options = { env: { ...process.env, ...environment, ...step.env } }
  const { code, said } = aside ? await npmAside(args, options) : { code: await npm(args, options), said: '' }
  if (aside) console.log(`${title}\n${said}`)
  const counted = countOf(step, code !== 0)
  const seconds = Math.round((Date.now() - began) / 1000)
  console.log(`── ${step.name}: ${good(counted) ? 'good' : 'FAILED'} (${seconds} s)`)
  return counted
}

/** One step after the other until one fails. */
export async function takeInOrder(steps, environment, aside = false) {
  const counts = []
  for (const step of steps) {
    counts.push(await take(step, environment, aside))
    if (!counts.every(good)) break
  }
  return counts
}

/** @param {string} report the file that Vitest writes @returns {Step} */
export const unitTests = (report) => ({
  name: 'unit tests',
  script: 'test:unit',
  args: ['--reporter=dot', '--reporter=json', `--outputFile.json=${report}`],
  count: () => countOfVitest(readJson(report)),
})

/** @param {string} report the file that Playwright writes @returns {Step} */
export const browserTests = (report) => ({
  name: 'browser tests',
  script: 'test:browser',
  args: ['--reporter=list,json'],
  env: { PLAYWRIGHT_JSON_OUTPUT_FILE: report },
  count: () => countBrowserTests(report),
})
