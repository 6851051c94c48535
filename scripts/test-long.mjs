// `npm run test:long`: everything that takes long by nature, at its whole length: every seed, every language, every
// mutated file. Run it alone on the machine, before a release; what it found is committed.
import { writeFileSync } from 'node:fs'
import { ensureChromium } from '../e2e/chromium.mjs'
import { specsOf } from './gate/rooms.mjs'
import { browserSuite, runSuite, unitSuite } from './gate/suite.mjs'
import { summarize } from './gate/summary.mjs'
import { listUnitTests } from './gate/tree.mjs'
import { inHouse as inRepo } from './prepare/house.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript } from './prepare/run.mjs'
import { take } from './prepare/steps.mjs'

const keyOf = () => null

/** Each step by its name. @type {{ name: string, run: (context: import('./gate/suite.mjs').Context) => Promise<object> }[]} */
const steps = [
  // The build writes messages for its pages alone; a unit test compares with all of them.
  ...['generate', 'build'].map((script) => ({
    name: script,
    run: ({ environment }) => take({ name: script, script }, environment),
  })),
  ...[
    unitSuite({ files: listUnitTests(), keyOf }),
    browserSuite({ name: 'browser tests', script: 'test:browser', files: specsOf([]), keyOf }),
  ].map((suite) => ({ name: suite.name, run: (context) => runSuite(suite, context) })),
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
  const start = Date.now()
  const environment = {
    CHROMIUM: await ensureChromium(),
    BOTGARTEN_LONG: '1',
    BOTGARTEN_LANGUAGES: 'all',
  }
  const context = { greens: new Map(), records: null, run: 'long', environment }
  const rows = []
  for (const { name, run } of steps) {
    const began = Date.now()
    const outcome = await run(context)
    rows.push({ ...outcome, name, seconds: Math.round((Date.now() - began) / 1000) })
  }
  writeFileSync(inRepo('benchmarks', 'results', 'test-long.md'), report(rows))
  return summarize(rows, start)
})
