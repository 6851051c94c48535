import { availableParallelism } from 'node:os'
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
/** Who asks which tests import a file (`vitest related`, the mutants) needs all modules in Vite's graph. */
const isRun = process.argv[2] === 'run'
const server = { deps: { external: isRun ? [packages] : [] } }
/** What Node has compiled is kept for the next test file. */
process.env['NODE_COMPILE_CACHE'] ??= `${import.meta.dirname}/node_modules/.cache/compiled`
const keeping = `${import.meta.dirname}/scripts/testing/keep-compiled.ts`

export default defineConfig({
  test: {
    // On two cores one worker leaves the other idle once the code has been read.
    maxWorkers: availableParallelism(),
    projects: [
      {
        resolve,
        test: {
          name: 'packages',
          server,
          setupFiles: [keeping],
          globalSetup: [`${import.meta.dirname}/packages/classroom/testing/no-postgres-left.ts`],
          // A slow machine may take its time; what hangs is still found.
          testTimeout: 60_000,
          hookTimeout: 60_000,
          include: [
            'packages/**/*.test.ts',
            'content/**/*.test.ts',
            'apps/cli/**/*.test.ts',
            'scripts/**/*.test.ts',
            'e2e/*.test.ts',
            'benchmarks/**/*.test.ts',
          ],
        },
      },
      {
        extends: 'apps/web/vite.config.ts',
        root: 'apps/web',
        resolve,
        test: {
          name: 'web',
          server,
          testTimeout: 60_000,
          hookTimeout: 60_000,
          include: ['src/**/*.test.ts'],
          setupFiles: [keeping, `${import.meta.dirname}/apps/web/src/words/all-languages.ts`],
        },
      },
    ],
  },
})
