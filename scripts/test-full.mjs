// `npm run test:full`: slow unit tests, all browser tests, the steps through all features, and every card, cage, map and race to
// its end, each in one language and by mouse or by finger. The commit's id decides in which, `--sample ID` repeats one.
// `--shard 1/3` runs a part of each, `--rooms sorting,network` only the browser tests of some rooms. A stopped run resumes;
// `--fresh` starts again.
import { parseArgs } from 'node:util'
import { ensureChromium } from '../e2e/chromium.mjs'
import { modeOf, prepare, readShard, walkSuite } from './gate/full.mjs'
import { readKeys } from './gate/keys.mjs'
import { flakyOf, forgetRun, readRecords, recordsFile } from './gate/records.mjs'
import { specsOf } from './gate/rooms.mjs'
import { commitId, partOf } from './gate/sample.mjs'
import { listSteps, stepsSuite } from './gate/steps.mjs'
import { browserSuite, runSuite, unitSuite } from './gate/suite.mjs'
import { summarize } from './gate/summary.mjs'
import { isSlow, listUnitTests } from './gate/tree.mjs'
import { inHouse as inRepo } from './prepare/house.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'
import { good } from './prepare/steps.mjs'

const options = {
  sample: { type: 'string' },
  shard: { type: 'string' },
  rooms: { type: 'string', default: '' },
  fresh: { type: 'boolean', default: false },
}

/** @param {{ shard: string | null, rooms: readonly string[], part: number, keys: ReturnType<typeof readKeys> }} options */
function suitesOf({ shard, rooms, part, keys }) {
  const keyOf = keys.ofSpec(modeOf(part, shard))
  const browser = browserSuite({
    ...{ name: 'browser tests', script: 'test:browser', keyOf, shard },
    files: specsOf(rooms),
  })
  if (rooms.length > 0) return [browser]
  const slow = unitSuite({
    ...{ name: 'slow unit tests', keyOf: keys.ofTest, shard },
    files: listUnitTests().filter(isSlow),
  })
  // Steps are the same in every sample, so that those of `npm test` do not run again.
  const files = listSteps().map(({ file }) => file)
  const steps = stepsSuite({ files, keyOf: keys.ofSpec(shard ?? ''), shard })
  return [slow, browser, steps, walkSuite({ keyOf, shard })]
}

async function runAll(suites, context) {
  const outcomes = await prepare(context.environment)
  if (!outcomes.every(good)) return outcomes
  // A failure in one suite hides nothing in the others.
  for (const suite of suites) outcomes.push(await runSuite(suite, context))
  return outcomes
}

await asScript(async () => {
  const { values } = parseArgs({ options })
  await installWhenNeeded()
  runtime()
  const [began, shard, sample] = [Date.now(), readShard(values.shard), values.sample ?? commitId()]
  const part = partOf(sample)
  console.log(`Sample ${sample}: part ${part}. The same again: npm run test:full -- --sample ${sample}`)
  const [records, rooms] = [recordsFile(), values.rooms.split(',').filter(Boolean)]
  const keys = readKeys()
  const run = `full, ${keys.whole}, ${part}`
  if (values.fresh) forgetRun(records, run)
  const context = {
    ...{ records, run, greens: readRecords(records) },
    environment: {
      CHROMIUM: await ensureChromium(),
      NODE_COMPILE_CACHE: inRepo('node_modules', '.cache', 'compiled'),
      BOTGARTEN_SAMPLE: String(part),
    },
  }
  const outcomes = await runAll(suitesOf({ shard, rooms, part, keys }), context)
  return summarize(outcomes, began, flakyOf(records, run))
})
