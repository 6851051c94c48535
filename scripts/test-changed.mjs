// `npm run test:changed`: what a change asks for before it is shown to anyone. Types, lint and the unit tests that import
// a changed file, side by side with the build; when all are good, the browser tests of the rooms that were changed.
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureChromium } from '../e2e/chromium.mjs'
import { isToBeBuilt } from './prepare/build.mjs'
import { changedFiles, specsOf } from './prepare/changed.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript } from './prepare/run.mjs'
import { browserTests, good, take, takeInOrder, unitTests } from './prepare/steps.mjs'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-changed-'))
/** Tests that read content/ by the names of its files. */
const readers = [
  ...['packages/content', 'packages/maps', 'packages/messages', 'apps/cli/words'],
  'apps/web/src/app/features',
]
const code = /\.(ts|mjs|js|svelte)$/

/** Types of the parts that a change can break: those that hold it, and those that import them. */
function typesOf(changed) {
  const shared = changed.some((file) => /^(packages|content|package-lock\.json|tsconfig)/.test(file))
  const touches = (...starts) =>
    shared || changed.some((file) => starts.some((start) => file.startsWith(start)))
  return [
    touches('apps/web/') && { name: 'types of the web app', script: 'types:web' },
    touches('apps/cli/', 'scripts/') && { name: 'types of packages and scripts', script: 'types:packages' },
    touches('e2e/') && { name: 'types of browser tests', script: 'types:e2e' },
    touches('benchmarks/') && { name: 'types of benchmarks', script: 'types:benchmarks' },
  ].filter(Boolean)
}

function checksOf(changed) {
  const files = changed.filter((file) => code.test(file))
  const lint = [
    files.length > 0 && { name: 'lint', script: 'lint', args: ['--no-warn-ignored', ...files] },
    files.length > 0 && { name: 'lint by types', script: 'lint:types', args: files },
    { name: 'format', script: 'formatted', args: ['--ignore-unknown', ...changed] },
  ].filter(Boolean)
  const tests = changed.filter((file) => code.test(file) && !file.startsWith('e2e/tests/'))
  const content = changed.some((file) => file.startsWith('content/'))
  const read = unitTests(join(folder, 'content.json'))
  const related = { ...unitTests(join(folder, 'unit.json')), script: 'test:related' }
  const args = [...related.args, '--passWithNoTests', ...tests]
  const units = [
    ...(tests.length > 0 ? [{ ...related, args }] : []),
    // What reads files by their names imports none of them.
    ...(content ? [{ ...read, args: [...read.args, ...readers] }] : []),
  ]
  return [typesOf(changed), [...lint, ...units]]
}

async function takeAll(changed) {
  const specs = specsOf(changed)
  const environment = { CHROMIUM: await ensureChromium(), NODE_COMPILE_CACHE: join(folder, 'compiled') }
  const counts = [await take({ name: 'generated files', script: 'generate' }, environment)]
  if (counts.every(good)) {
    const built = specs.length > 0 && isToBeBuilt() ? [[{ name: 'build', script: 'build' }]] : []
    const lanes = [...built, ...checksOf(changed)].map((steps) => takeInOrder(steps, environment, true))
    counts.push(...(await Promise.all(lanes)).flat())
  }
  if (counts.every(good) && specs.length > 0) {
    const tests = browserTests(join(folder, 'browser.json'))
    const names = specs.map((file) => file.replace('e2e/', ''))
    counts.push(await take({ ...tests, args: [...tests.args, ...names] }, environment))
  }
  return counts
}

await asScript(async () => {
  await installWhenNeeded()
  const began = Date.now()
  const changed = changedFiles(process.argv[2])
  if (changed.length === 0) {
    console.log('Nothing differs from main.')
    return 0
  }
  const counts = await takeAll(changed)
  rmSync(folder, { recursive: true, force: true })
  const [passed, failed] = ['passed', 'failed'].map((what) =>
    counts.reduce((sum, count) => sum + count[what], 0),
  )
  console.log(
    `\n${changed.length} files changed: ${passed} passed, ${failed} failed (${Math.round((Date.now() - began) / 1000)} s)`,
  )
  return failed === 0 ? 0 : 1
})
