// `npm run walk`: every card, cage, map and race of the built lab to its end, in both languages, by mouse and by finger. These
// four variants are the four samples of `npm run test:full`, here one after the other; `--sample 2` takes one of them.
// `--shard 1/3` runs a part of each. A stopped run resumes; `--fresh` starts again. `npm run walk:some -- -g fear` walks one.
import { parseArgs } from 'node:util'
import { ensureChromium } from '../e2e/chromium.mjs'
import { modeOf, prepare, readShard, walkSuite } from './gate/full.mjs'
import { readKeys } from './gate/keys.mjs'
import { flakyOf, forgetRun, readRecords, recordsFile } from './gate/records.mjs'
import { partOf, PARTS } from './gate/sample.mjs'
import { runSuite } from './gate/suite.mjs'
import { summarize } from './gate/summary.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'
import { good } from './prepare/steps.mjs'

const options = {
  sample: { type: 'string' },
  shard: { type: 'string' },
  fresh: { type: 'boolean', default: false },
}

await asScript(async () => {
  const { values } = parseArgs({ options })
  await installWhenNeeded()
  runtime()
  const [began, shard, records] = [Date.now(), readShard(values.shard), recordsFile()]
  const samples = values.sample === undefined ? [...Array(PARTS).keys()] : [partOf(values.sample)]
  const keys = readKeys()
  const run = `walks, ${keys.whole}`
  if (values.fresh) forgetRun(records, run)
  const context = { records, run, greens: readRecords(records) }
  const environment = { CHROMIUM: await ensureChromium() }
  const outcomes = await prepare(environment)
  if (outcomes.every(good))
    for (const sample of samples) {
      const suite = walkSuite({ keyOf: keys.ofSpec(modeOf(sample, shard)), shard })
      // A failure in one sample hides nothing in the others.
      outcomes.push(
        await runSuite(
          { ...suite, name: `${suite.name}, sample ${sample}` },
          { ...context, environment: { ...environment, BOTGARTEN_SAMPLE: String(sample) } },
        ),
      )
    }
  return summarize(outcomes, began, flakyOf(records, run))
})
