// One warm Vitest in a copy of the tree. Its parent sends files with a fault and gets back whether a test has failed.
import { existsSync, readFileSync, renameSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { createVitest, type TestModule, type TestSpecification } from 'vitest/node'

export interface Request {
  /** A file below the copy's folder, and its text with a fault; null: all tests of the folders run without a fault. */
  readonly fault: { readonly file: string; readonly text: string } | null
  /** Tests outside of these folders do not run. */
  readonly tests: readonly string[]
  /** Tests that are asked whatever they import. */
  readonly walking: readonly string[]
}

export type Answer =
  /** `progress`: a test has ended. */
  | { readonly kind: 'ready' | 'progress' }
  | { readonly kind: 'killed' | 'survived' | 'unasked'; readonly by?: string }

const root = process.cwd()
const say = (answer: Answer) => process.send!(answer)

const vitest = await createVitest('test', {
  ...{ root, watch: false, run: true, bail: 1, maxWorkers: 1, fileParallelism: false },
  ...{
    reporters: [{ onTestCaseResult: () => void say({ kind: 'progress' }) }],
    silent: true,
    testTimeout: 20_000,
    passWithNoTests: true,
    cache: false,
  },
})

/** Groups of tests in the order in which they run: the first group that fails ends the run. */
type Tests = readonly (readonly TestSpecification[])[]
const specs = new Map<string, Promise<Tests>>()

/** The tests for a file: those with its name, those in its folder, then the others. */
function testsOf(file: string, request: Request): Promise<Tests> {
  const found = specs.get(file) ?? related(join(root, file), request)
  specs.set(file, found)
  return found
}

const below = (folders: readonly string[]) => folders.map((folder) => join(root, folder, '/'))

async function related(path: string, { tests, walking }: Request): Promise<Tests> {
  vitest.config.related = [path]
  const importing = await vitest.getRelevantTestSpecifications(below(tests))
  const asked = new Set(importing.map(({ moduleId }) => moduleId))
  const found = walking.length === 0 ? [] : await vitest.globTestSpecifications([...walking])
  const all = [...importing, ...found.filter(({ moduleId }) => !asked.has(moduleId))]
  const name = path.replace(/(\.svelte)?\.ts$/, '.')
  const distance = ({ moduleId }: TestSpecification) =>
    moduleId.startsWith(name) ? 0 : dirname(moduleId) === dirname(path) ? 1 : 2
  return [0, 1, 2]
    .map((one) => all.filter((spec) => distance(spec) === one))
    .filter(({ length }) => length > 0)
}

async function wholeRoom({ tests, walking }: Request): Promise<Tests> {
  return [await vitest.globTestSpecifications([...below(tests), ...walking])]
}

async function ask(request: Request): Promise<Answer> {
  if (request.fault === null) return await run(await wholeRoom(request))
  const { file, text } = request.fault
  const path = join(root, file)
  const before = readFileSync(path, 'utf8')
  const chosen = await testsOf(file, request)
  if (chosen.length === 0) return { kind: 'unasked' }
  put(path, text)
  try {
    return await run(chosen)
  } finally {
    put(path, before)
  }
}

async function run(groups: Tests): Promise<Answer> {
  for (const some of groups) {
    const { testModules, unhandledErrors } = await vitest.runTestSpecifications([...some])
    // Vitest also gives what failed in runs before and was not asked now.
    const asked = new Set(some.map(({ moduleId }) => moduleId))
    const failed = testModules.find((one) => asked.has(one.moduleId) && one.state() === 'failed')
    if (failed) return { kind: 'killed', by: reasonOf(failed) }
    if (unhandledErrors.length > 0) return { kind: 'killed' }
  }
  return { kind: 'survived' }
}

function reasonOf(failed: TestModule): string {
  const [test] = failed.children.allTests('failed')
  const [error] = test?.result().errors ?? failed.errors()
  return [failed.relativeModuleId, test?.fullName, error?.message].join(': ')
}

/** The copy may share files with the original: they are replaced, never written into. */
function put(path: string, text: string): void {
  const fresh = `${path}.mutant`
  writeFileSync(fresh, text)
  renameSync(fresh, path)
  vitest.invalidateFile(path)
}

if (!existsSync(join(root, '.mutants'))) throw new Error('This is no copy: it must not be changed.')
process.on('message', (request: Request) => void ask(request).then(say))
process.once('disconnect', () => process.exit())
say({ kind: 'ready' })
