// `npm run stress -- browser --round 1`: runs tests while four busy loops load the machine, to find those that wait too short a
// time. `units`, `browser` or `gate`; `--shard 1/4` runs a part. Outcomes are appended to test-results/stress.jsonl; a round that
// was stopped resumes after the files in it.
import { spawn } from 'node:child_process'
import { appendFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { parseArgs } from 'node:util'
import { ensureChromium } from '../e2e/chromium.mjs'
import { specsOf } from './gate/rooms.mjs'
import { browserSuite, runSuite, unitSuite } from './gate/suite.mjs'
import { summarize } from './gate/summary.mjs'
import { listFiles, listUnitTests } from './gate/tree.mjs'
import { isToBeBuilt } from './prepare/build.mjs'
import { inHouse as inRepo } from './prepare/house.mjs'
import { asScript, Trouble } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'
import { good, take } from './prepare/steps.mjs'

const LOOPS = 4
const file = inRepo('test-results', 'stress.jsonl')
const keyOf = () => null

const suites = {
  units: (files) => unitSuite({ files, keyOf }),
  browser: (files) => browserSuite({ name: 'browser tests', script: 'test:browser', files, keyOf }),
  gate: (files) => browserSuite({ name: 'walk through every feature', script: 'test:gate', files, keyOf }),
}
const filesOf = {
  units: listUnitTests,
  browser: () => specsOf([]),
  gate: () => listFiles('e2e/gate', '.spec.ts', '.touch.ts'),
}

/** Busy loops end with this process, however it ends: their standard input closes. */
function startLoops() {
  const loop = `process.stdin.resume().on('end', () => process.exit()).on('close', () => process.exit())
    const turn = () => { for (const end = Date.now() + 50; Date.now() < end;); setImmediate(turn) }
    turn()`
  const loops = Array.from({ length: LOOPS }, () =>
    spawn(runtime(), ['-e', loop], { stdio: ['pipe', 'ignore', 'inherit'] }),
  )
  return () => loops.forEach((one) => one.kill())
}

/** @param {string} text `1/4` @returns {(file: string, index: number) => boolean} */
function isInShard(text) {
  const [, index, count] = /^([1-9]\d*)\/([1-9]\d*)$/.exec(text) ?? []
  if (!(Number(index) <= Number(count)))
    throw new Trouble('--shard needs a part and a number of parts, such as 1/4.')
  return (_file, at) => at % Number(count) === Number(index) - 1
}

const readOutcomes = () =>
  existsSync(file)
    ? readFileSync(file, 'utf8')
        .split('\n')
        .filter(Boolean)
        .map((line) => JSON.parse(line))
    : []

/** Runs a few files at a time, so that little is lost when the run is stopped. @param {number} size */
const batches = (files, size) =>
  Array.from({ length: Math.ceil(files.length / size) }, (_, index) =>
    files.slice(index * size, (index + 1) * size),
  )

await asScript(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { shard: { type: 'string', default: '1/1' }, round: { type: 'string', default: '1' } },
  })
  const [kind = 'browser'] = positionals
  if (!Object.hasOwn(suites, kind)) throw new Trouble(`There is no ${kind}: units, browser or gate.`)
  const began = Date.now()
  const isSame = (one) => one.kind === kind && one.round === values.round
  const done = new Set(
    readOutcomes()
      .filter(isSame)
      .flatMap(({ files }) => files),
  )
  const files = filesOf[kind]()
    .filter(isInShard(values.shard))
    .filter((one) => !done.has(one))
  const context = {
    ...{ greens: new Map(), records: null, run: 'stress' },
    environment: { CHROMIUM: await ensureChromium() },
  }
  mkdirSync(dirname(file), { recursive: true })
  const isBuilt = !isToBeBuilt() || good(await take({ name: 'build', script: 'build' }, context.environment))
  if (!isBuilt) throw new Trouble('The lab could not be built.')
  const stopLoops = startLoops()
  try {
    for (const batch of batches(files, kind === 'units' ? 60 : 12)) {
      const { passed, failed, flaky, results } = await runSuite(suites[kind](batch), context)
      const failures = results.filter(({ outcome }) => outcome === 'failed' || outcome === 'skipped')
      const line = { kind, round: values.round, files: batch, passed, failed, flaky, failures }
      appendFileSync(file, `${JSON.stringify(line)}\n`)
    }
  } finally {
    stopLoops()
  }
  return summarize(readOutcomes().filter(isSame), began)
})
