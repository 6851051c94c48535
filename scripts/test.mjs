// `npm test`. Every step is an npm script that can be run alone. Types and lint run side by side and both say what
// they found; after that the first step that fails ends it.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureChromium } from '../e2e/chromium.mjs'
import { countOfPlaywright, countOfVitest, failedIn, oneStep } from './prepare/counts.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript, npm, npmAside } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-test-'))
const unit = join(folder, 'unit.json')
const browser = join(folder, 'browser.json')

/** @typedef {{ name: string, script: string, args?: string[], env?: object, count?: (failed: boolean) => { passed: number, failed: number } }} Step */

/** Writes what the other steps read: messages and the types of pages. @type {Step} */
const generate = { name: 'generated files', script: 'generate' }

/** What only reads the code, in two lanes that take equally long on two cores. @type {Step[][]} */
const checks = [
  [
    { name: 'types', script: 'types' },
    { name: 'arrows between rooms', script: 'check:arrows' },
    { name: 'unused code', script: 'check:unused' },
    { name: 'build', script: 'build' },
    { name: 'sizes', script: 'check:sizes' },
  ],
  [{ name: 'lint', script: 'check:lint' }],
]

/** @type {Step} */
const unitTests = {
  name: 'unit tests',
  script: 'test:unit',
  args: ['--reporter=dot', '--reporter=json', `--outputFile.json=${unit}`],
  count: () => countOfVitest(readJson(unit)),
}

/** @type {Step} */
const browserTests = {
  name: 'browser tests',
  script: 'test:browser',
  args: ['--reporter=list,json'],
  env: { PLAYWRIGHT_JSON_OUTPUT_FILE: browser },
  count: countBrowserTests,
}

/** What a page held may be long; its first lines tell where the child was. */
const mostOfAPage = 6000

/** Counts the browser tests, and shows what the pages of those held that failed. */
function countBrowserTests() {
  const report = readJson(browser)
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

const good = ({ failed }) => failed === 0

/** Runs one step. `aside`: what it says is shown as a whole at its end. */
async function take(step, environment, aside = false) {
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
async function takeInOrder(steps, environment, aside = false) {
  const counts = []
  for (const step of steps) {
    counts.push(await take(step, environment, aside))
    if (!counts.every(good)) break
  }
  return counts
}

async function takeAll() {
  // Programs that are started many times are compiled once.
  const environment = { CHROMIUM: await ensureChromium(), NODE_COMPILE_CACHE: join(folder, 'compiled') }
  const counts = [await take(generate, environment)]
  if (counts.every(good)) {
    const lanes = checks.map((steps) => takeInOrder(steps, environment, true))
    counts.push(...(await Promise.all(lanes)).flat())
  }
  if (counts.every(good)) counts.push(...(await takeInOrder([unitTests, browserTests], environment)))
  return {
    passed: counts.reduce((sum, { passed }) => sum + passed, 0),
    failed: counts.reduce((sum, { failed }) => sum + failed, 0),
  }
}

await asScript(async () => {
  await installWhenNeeded()
  // Says what to do where there is no Node new enough for the steps.
  runtime()
  const { passed, failed } = await takeAll()
  rmSync(folder, { recursive: true, force: true })
  console.log(`\n${passed} passed, ${failed} failed`)
  return failed === 0 ? 0 : 1
})
