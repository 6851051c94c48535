// `npm test`: types, lint, format, arrows, unused code, build, sizes, unit tests, and in a browser a walk through every feature
// and the steps through the features that the last commit or uncommitted changes touch. Every step is an npm script that can be
// run alone. Checks and test files that were green in this clone and depend on no file that has changed since do not run again;
// `npm test -- --fresh` runs everything.
import { parseArgs } from 'node:util'
import { ensureChromium } from '../e2e/chromium.mjs'
import { readKeys } from './gate/keys.mjs'
import { addRecord, readRecords, recordsFile } from './gate/records.mjs'
import { changedPaths, stepsOf, stepsSuite } from './gate/steps.mjs'
import { browserSuite, runSuite, unitSuite } from './gate/suite.mjs'
import { summarize } from './gate/summary.mjs'
import { isSlow, listFiles, listUnitTests } from './gate/tree.mjs'
import { isToBeBuilt } from './prepare/build.mjs'
import { inHouse as inRepo } from './prepare/house.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'
import { good, take, takeInOrder } from './prepare/steps.mjs'

/** Writes messages and the types of pages for the other steps. @type {import('./prepare/steps.mjs').Step} */
const generate = { name: 'generated files', script: 'generate' }
const build = { name: 'build', script: 'build' }
const sizes = { name: 'sizes', script: 'check:sizes' }

/** Checks that only read the code, in two lanes that take equally long on two cores. @type {import('./prepare/steps.mjs').Step[][]} */
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
    { name: 'prose', script: 'check:prose' },
  ],
]

/** Runs the checks without a record for the present tree, and the build if its sources have changed. */
async function runChecks({ keys, greens, records, environment }) {
  const keyOf = ({ name }) => keys.ofStep(name)
  const isKnown = (step) => greens.has(keyOf(step) ?? '')
  const lanes = checks.map((steps) => steps.filter((step) => !isKnown(step)))
  lanes[1].push(...(isToBeBuilt() ? [build] : []), sizes)
  const counts = await Promise.all(
    lanes.map(async (steps) => {
      const taken = await takeInOrder(steps, environment, true)
      taken.forEach((count, index) => {
        const key = keyOf(steps[index])
        if (good(count) && key !== null) addRecord(records, { key, passed: 1, flaky: [] })
      })
      return taken
    }),
  )
  const known = checks.flat().filter(isKnown).length
  return [...counts.flat(), { passed: known, failed: 0, known }]
}

async function runAll(context) {
  const { keys } = context
  const outcomes = [await take(generate, context.environment)]
  if (outcomes.every(good)) outcomes.push(...(await runChecks(context)))
  const units = unitSuite({ files: listUnitTests().filter((file) => !isSlow(file)), keyOf: keys.ofTest })
  const walk = browserSuite({
    ...{ name: 'walk through every feature', script: 'test:gate', keyOf: keys.ofSpec() },
    files: listFiles('e2e/gate', '.spec.ts', '.touch.ts'),
  })
  const steps = stepsSuite({ files: stepsOf(changedPaths()), keyOf: keys.ofSpec() })
  for (const suite of [units, walk, steps])
    if (outcomes.every(good)) outcomes.push(await runSuite(suite, context))
  return outcomes
}

await asScript(async () => {
  const { values } = parseArgs({ options: { fresh: { type: 'boolean', default: false } } })
  await installWhenNeeded()
  // Reports an error if no Node is new enough for the steps.
  runtime()
  const began = Date.now()
  const records = recordsFile()
  const context = {
    records,
    greens: readRecords(values.fresh ? null : records),
    keys: readKeys(),
    run: 'npm test',
    // Programs that are started many times are compiled once.
    environment: {
      CHROMIUM: await ensureChromium(),
      NODE_COMPILE_CACHE: inRepo('node_modules', '.cache', 'compiled'),
    },
  }
  return summarize(await runAll(context), began)
})
