// `npm run walk:faults`: makes one small fault at a time in a view, in a copy of the tree, builds it and runs the walk of
// `npm test`, which has to turn red. `--count 10`, `--seed 1`, `--from 3` skips the first three, `--out` appends each line
// to a file, `--feature races` draws all of them in one feature and runs its tests alone.
import { spawnSync } from 'node:child_process'
import { appendFileSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { copyTree } from './mutants/copy.ts'
import { drawFaults, type ViewFault } from './mutants/views.ts'
import { inHouse } from './prepare/house.mjs'
import { asScript, Trouble } from './prepare/run.mjs'

/** The first red test in Playwright's output. */
const redIn = (output: string) => /^ {2}1\) \[gate\] › (.+?)(?: ─+)? *$/m.exec(output)?.[1] ?? 'the walk'

/** Throws if the script ended by a signal or did not start: neither is a result. npm reports both as a status from 127 on. */
function runNpm(cwd: string, args: readonly string[]) {
  const options = { cwd, encoding: 'utf8', maxBuffer: 2 ** 28 } as const
  const { status, signal, error, stdout } = spawnSync('npm', ['run', '--silent', ...args], options)
  if (status === null || status >= 127)
    throw new Trouble(`npm run ${args[0]} was ended: ${signal ?? error?.message ?? `status ${status}`}`)
  return { status, stdout }
}

/** The outcome of one fault: the first red test, or `survived`. Tests and steps of its own feature run first: they take seconds. */
function outcomeOf(copy: string, file: string, all: boolean): string {
  const npm = (...args: readonly string[]) => runNpm(copy, args)
  if (npm('build').status !== 0) return 'caught by the build'
  const [feature] = file.replace('apps/web/src/features/', '').split('/')
  const own = ['--grep', `@${feature}(?![\\w-])`]
  const runs = [
    ['test:gate', ...own],
    ['test:steps', ...own],
  ]
  for (const [script = '', ...some] of all ? [...runs, ['test:gate']] : runs) {
    const { status, stdout } = npm(script, '--', '-x', '--retries=0', '--pass-with-no-tests', ...some)
    if (status !== 0) return `caught by ${redIn(stdout)}`
  }
  return 'survived'
}

/** Puts a fault into the copy, and takes it out again. */
function tryFault(copy: string, { file, text }: ViewFault, all: boolean): string {
  const before = readFileSync(join(copy, file), 'utf8')
  writeFileSync(join(copy, file), text)
  try {
    return outcomeOf(copy, file, all)
  } finally {
    writeFileSync(join(copy, file), before)
  }
}

await asScript(async () => {
  const { values } = parseArgs({
    options: {
      count: { type: 'string', default: '10' },
      seed: { type: 'string', default: '1' },
      from: { type: 'string', default: '0' },
      out: { type: 'string' },
      feature: { type: 'string' },
    },
  })
  const [count, seed, from] = [Number(values.count), Number(values.seed), Number(values.from)]
  const { feature } = values
  const faults = drawFaults(inHouse('.'), { count, seed, feature })
  const copy = copyTree(inHouse('.'))
  let survived = 0
  try {
    for (const [at, fault] of faults.entries()) {
      if (at < from) continue
      const outcome = tryFault(copy, fault, feature === undefined)
      if (outcome === 'survived') survived += 1
      const change = fault.change.replaceAll('|', '\\|').replaceAll('`', "'")
      const line = `| ${at + 1} | ${fault.kind} | ${fault.file}:${fault.line} | \`${change}\` | ${outcome} |`
      console.log(line)
      if (values.out) appendFileSync(values.out, `${line}\n`)
    }
  } finally {
    rmSync(copy, { recursive: true, force: true })
  }
  const tried = faults.length - from
  console.log(`\n${tried - survived} of ${tried} faults in views caught (seed ${seed})`)
  return Promise.resolve(survived / tried > 0.3 ? 1 : 0)
})
