// `npm run test:long`: everything that takes long by nature, at its whole length: every seed, every language, every
// mutated file. Run it alone on the machine, before an issue is closed; what it found is committed.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureChromium } from '../e2e/chromium.mjs'
import { inHouse } from './prepare/house.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript } from './prepare/run.mjs'
import { browserTests, good, take, unitTests } from './prepare/steps.mjs'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-long-'))

const steps = [
  // The build makes messages for its pages alone; a unit test compares with all of them.
  { name: 'generated files', script: 'generate' },
  { name: 'build', script: 'build' },
  unitTests(join(folder, 'unit.json')),
  browserTests(join(folder, 'browser.json')),
]

function report(rows) {
  const lines = rows.map(
    ({ name, passed, failed, seconds }) => `| ${name} | ${passed} | ${failed} | ${seconds} |`,
  )
  return `# Tests at their whole length

Made by \`npm run test:long\`.

| step | passed | failed | seconds |
| --- | --: | --: | --: |
${lines.join('\n')}
`
}

await asScript(async () => {
  await installWhenNeeded()
  const environment = {
    CHROMIUM: await ensureChromium(),
    BOTGARTEN_LONG: '1',
    BOTGARTEN_LANGUAGES: 'all',
  }
  const rows = []
  for (const step of steps) {
    const began = Date.now()
    const counted = await take(step, environment)
    rows.push({ name: step.name, ...counted, seconds: Math.round((Date.now() - began) / 1000) })
  }
  rmSync(folder, { recursive: true, force: true })
  writeFileSync(inHouse('benchmarks', 'results', 'test-long.md'), report(rows))
  return rows.every(good) ? 0 : 1
})
