// `npm test`. Every step is an npm script that can be run alone; the first one that fails ends it.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureChromium } from '../e2e/chromium.mjs'
import { countOfPlaywright, countOfVitest, oneStep } from './prepare/counts.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript, npm } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-test-'))
const unit = join(folder, 'unit.json')
const browser = join(folder, 'browser.json')

/** @type {{ name: string, script: string, args?: string[], env?: object, count?: (failed: boolean) => { passed: number, failed: number } }[]} */
const steps = [
  { name: 'types', script: 'check:types' },
  { name: 'lint', script: 'check:lint' },
  { name: 'arrows between rooms', script: 'check:arrows' },
  { name: 'unused code', script: 'check:unused' },
  {
    name: 'unit tests',
    script: 'test:unit',
    args: ['--reporter=dot', '--reporter=json', `--outputFile.json=${unit}`],
    count: () => countOfVitest(readJson(unit)),
  },
  { name: 'build', script: 'build' },
  { name: 'sizes', script: 'check:sizes' },
  {
    name: 'browser tests',
    script: 'test:browser',
    args: ['--reporter=list,json'],
    env: { PLAYWRIGHT_JSON_OUTPUT_FILE: browser },
    count: () => countOfPlaywright(readJson(browser)),
  },
]

const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'))

/** What a step counted; a step that broke before it could count is one failure. */
function countOf({ count = oneStep }, failed) {
  try {
    const counted = count(failed)
    return failed && counted.failed === 0 ? { ...counted, failed: 1 } : counted
  } catch {
    return oneStep(failed)
  }
}

async function take(step, environment) {
  console.log(`\n── ${step.name} (npm run ${step.script})`)
  const began = Date.now()
  const code = await npm(['run', '--silent', step.script, ...(step.args ? ['--', ...step.args] : [])], {
    env: { ...process.env, ...environment, ...step.env },
  })
  const counted = countOf(step, code !== 0)
  console.log(
    `── ${step.name}: ${counted.failed === 0 ? 'good' : 'FAILED'} (${Math.round((Date.now() - began) / 1000)} s)`,
  )
  return counted
}

async function takeAll() {
  const sum = { passed: 0, failed: 0 }
  const environment = { CHROMIUM: await ensureChromium() }
  for (const step of steps) {
    const { passed, failed } = await take(step, environment)
    sum.passed += passed
    sum.failed += failed
    if (failed > 0) break
  }
  return sum
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
