import { globSync, readFileSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { relative } from 'node:path'
import { defineConfig } from 'vitest/config'

/** Tests find the same cases on every run. */
const resolve = {
  alias: [{ find: /^fast-check$/, replacement: `${import.meta.dirname}/scripts/testing/fast-check.ts` }],
}

/**
 * Node itself reads packages and the command line, as in the product: a module that Vite rewrites looks up every imported
 * name at every use, and comes to each test file by a question to another process. Tests and their helpers are Vite's.
 */
const packages = /\/(packages|apps\/cli)\/(?!.*(\/testing\/|\/testing\.ts|\.test\.ts|node_modules)).*\.ts$/
/** To find the tests that import a file (`vitest related`, the mutants), Vite's graph needs all modules. */
const isRun = process.argv[2] === 'run'
const server = { deps: { external: isRun ? [packages] : [] } }
/** Node's compiled code is cached for the next test file. */
process.env['NODE_COMPILE_CACHE'] ??= `${import.meta.dirname}/node_modules/.cache/compiled`
const keeping = `${import.meta.dirname}/scripts/testing/keep-compiled.ts`
const restoring = `${import.meta.dirname}/scripts/testing/restore.ts`

/** A step of `npm test` lists the files that it runs, one a line (scripts/gate/suite.mjs). */
const listed = process.env['BOTGARTEN_TEST_FILES']
const files = listed === undefined ? null : readFileSync(listed, 'utf8').split('\n')

/**
 * The test files of a project: the listed ones, or all files that match its patterns.
 * @param folder the project's root
 */
const included = (
  isOurs: (file: string) => boolean,
  folder: string,
  patterns: readonly string[],
): string[] => (files === null ? [...patterns] : files.filter(isOurs).map((file) => relative(folder, file)))

/** Packages without state of their own: one process runs all of their tests, which saves a third of the time. */
const shared = [
  'answers',
  'blocks',
  'content',
  'experiments',
  'lab',
  'learning',
  'maps',
  'messages',
  'numbers',
  'simulation',
]
const isShared = (file: string) => shared.some((name) => file.startsWith(`packages/${name}/`))
const isWeb = (file: string) => file.startsWith('apps/web/')
/** A module that a test replaces must not be loaded yet: another test file of the same process may have done that. */
const mocking = globSync('src/**/*.test.ts', { cwd: `${import.meta.dirname}/apps/web` })
  .map((file) => file.replaceAll('\\', '/'))
  .filter((file) => readFileSync(`${import.meta.dirname}/apps/web/${file}`, 'utf8').includes('vi.mock('))
/**
 * Tests of the web that need a process of their own, relative to its folder: they replace a module, test one that has not loaded
 * anything yet, or Blockly, which has one registry of blocks a process. All others share a process, which takes a quarter of the time.
 */
const alone = [
  'src/features/editor',
  'src/features/materials/library.test.ts',
  'src/words/language.test.ts',
  ...mocking.filter((file) => !file.endsWith('.effects.test.ts')),
]
const isAlone = (file: string) => alone.some((one) => file.startsWith(`apps/web/${one}`))
const testsOf = (...folders: readonly string[]) => folders.map((folder) => `${folder}/**/*.test.ts`)

const aloneTests = alone.map((one) => (one.endsWith('.ts') ? one : `${one}/**/*.test.ts`))

/** Tests in which effects run, as in a browser: elsewhere Svelte's modules are those of a server. */
const effects = '**/*.effects.test.ts'

const allLanguages = `${import.meta.dirname}/apps/web/src/words/all-languages.ts`

const limits = {
  // Long enough for a slow machine; a test that hangs still fails.
  testTimeout: 60_000,
  hookTimeout: 60_000,
  // A project that extends another file does not inherit this from the root. On two cores one worker leaves the other idle.
  maxWorkers: availableParallelism(),
}

export default defineConfig({
  test: {
    projects: [
      {
        resolve,
        test: {
          ...limits,
          name: 'shared',
          server,
          setupFiles: [keeping, restoring],
          isolate: false,
          include: included(isShared, '', testsOf(...shared.map((name) => `packages/${name}`))),
        },
      },
      {
        resolve,
        test: {
          ...limits,
          name: 'packages',
          server,
          setupFiles: [keeping],
          globalSetup: [`${import.meta.dirname}/packages/classroom/testing/no-postgres-left.ts`],
          include: included((file) => !isWeb(file) && !isShared(file), '', [
            ...testsOf('packages', 'content', 'apps/cli', 'scripts', 'benchmarks'),
            'e2e/*.test.ts',
          ]),
          exclude: ['**/node_modules/**', ...testsOf(...shared.map((name) => `packages/${name}`))],
        },
      },
      {
        extends: 'apps/web/vite.config.ts',
        root: 'apps/web',
        resolve,
        test: {
          ...limits,
          name: 'web',
          server,
          isolate: false,
          include: included(isWeb, 'apps/web', testsOf('src')),
          exclude: ['**/node_modules/**', effects, ...aloneTests],
          setupFiles: [keeping, restoring, allLanguages],
        },
      },
      {
        extends: 'apps/web/vite.config.ts',
        root: 'apps/web',
        resolve,
        test: {
          ...limits,
          name: 'web alone',
          server,
          include: included(isAlone, 'apps/web', aloneTests),
          setupFiles: [keeping, allLanguages],
        },
      },
      {
        extends: 'apps/web/vite.config.ts',
        root: 'apps/web',
        resolve: { ...resolve, conditions: ['browser', 'module', 'import'] },
        test: {
          ...limits,
          name: 'effects',
          environment: `${import.meta.dirname}/scripts/testing/effects.ts`,
          server: { deps: { external: server.deps.external, inline: ['svelte', 'esm-env'] } },
          include: included((file) => isWeb(file) && file.endsWith('.effects.test.ts'), 'apps/web', [
            effects,
          ]),
          setupFiles: [keeping, allLanguages],
        },
      },
    ],
  },
})
