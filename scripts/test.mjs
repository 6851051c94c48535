// `npm test`. Every step is an npm script that can be run alone. Types and lint run side by side and both say what
// they found; after that the first step that fails ends it.
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureChromium } from '../e2e/chromium.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'
import { browserTests, good, take, takeInOrder, unitTests } from './prepare/steps.mjs'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-test-'))
const unit = join(folder, 'unit.json')
const browser = join(folder, 'browser.json')

/** Writes what the other steps read: messages and the types of pages. @type {import('./prepare/steps.mjs').Step} */
const generate = { name: 'generated files', script: 'generate' }

/** What only reads the code, in two lanes that take equally long on two cores. @type {import('./prepare/steps.mjs').Step[][]} */
const checks = [
  [
    { name: 'types', script: 'types' },
    { name: 'format', script: 'formatted', args: ['.'] },
  ],
  [
    { name: 'lint', script: 'lint', args: ['.'] },
    { name: 'lint by types', script: 'lint:types' },
    { name: 'arrows between rooms', script: 'check:arrows' },
    { name: 'unused code', script: 'check:unused' },
    { name: 'build', script: 'build' },
    { name: 'sizes', script: 'check:sizes' },
  ],
]

async function takeAll() {
  // Programs that are started many times are compiled once.
  const environment = { CHROMIUM: await ensureChromium(), NODE_COMPILE_CACHE: join(folder, 'compiled') }
  const counts = [await take(generate, environment)]
  if (counts.every(good)) {
    const lanes = checks.map((steps) => takeInOrder(steps, environment, true))
    counts.push(...(await Promise.all(lanes)).flat())
  }
  if (counts.every(good))
    counts.push(...(await takeInOrder([unitTests(unit), browserTests(browser)], environment)))
  return {
    passed: counts.reduce((sum, { passed }) => sum + passed, 0),
    failed: counts.reduce((sum, { failed }) => sum + failed, 0),
  }
}

await asScript(async () => {
  await installWhenNeeded()
  // Says what to do where there is no Node new enough for the steps.
  runtime()
  const began = Date.now()
  const { passed, failed } = await takeAll()
  rmSync(folder, { recursive: true, force: true })
  console.log(`\n${passed} passed, ${failed} failed (${Math.round((Date.now() - began) / 1000)} s)`)
  return failed === 0 ? 0 : 1
})
