import { availableParallelism } from 'node:os'
import { defineConfig } from 'vitest/config'

/** Tests find the same cases on every run. */
const resolve = {
  alias: [{ find: /^fast-check$/, replacement: `${import.meta.dirname}/scripts/testing/fast-check.ts` }],
}

export default defineConfig({
  test: {
    // On two cores one worker leaves the other idle once the code has been read.
    maxWorkers: availableParallelism(),
    projects: [
      {
        resolve,
        test: {
          name: 'packages',
          // A slow machine may take its time; what hangs is still found.
          testTimeout: 60_000,
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
          testTimeout: 60_000,
          include: ['src/**/*.test.ts'],
          setupFiles: [`${import.meta.dirname}/apps/web/src/words/all-languages.ts`],
        },
      },
    ],
  },
})
