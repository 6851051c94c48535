import { defineConfig } from '@playwright/test'
import { flags } from './browser.ts'
import { findChromium } from './chromium.mjs'
import { tablet, type HandName } from './hand.ts'

const executablePath = findChromium() ?? undefined
const desktop = { viewport: { width: 1366, height: 768 } }

/**
 * One page serves test after test, emptied in between: scripts that were read once are not read again, which is half of
 * what a test takes. For that the page has to stay in its process, also over an empty page.
 */
const warm = ['--disable-site-isolation-trials', '--process-per-site']

/** These need a browser that nobody has used: what travels, what lies on the disk, what is there without a network. */
const unused = ['journey', 'kept', 'late-parts', 'offline', 'own-house', 'said', 'static', 'traffic'].map(
  (name) => `**/${name}.spec.ts`,
)

export default defineConfig<{ hand: HandName }>({
  testDir: 'tests',
  outputDir: 'test-results',
  // Tests wait longer than they compute: four keep two cores busy.
  workers: 4,
  fullyParallel: true,
  forbidOnly: true,
  // A test that needs a further try is listed as flaky. Tests of storage, saving, classes and undo set 0.
  retries: 2,
  timeout: 120_000,
  expect: { timeout: 30_000 },
  reporter: 'list',
  use: {
    launchOptions: { executablePath, args: [...flags, ...warm] },
    reuseContext: true,
    // A trace makes every test three times as slow; `--trace on` has one where it is wanted.
    trace: 'off',
    // It keeps 1.6 MB in every fresh browser: tests of what is kept, and of the whole journey, allow it.
    serviceWorkers: 'block',
    screenshot: 'only-on-failure',
  },
  projects: [
    { name: 'desktop', use: desktop, testIgnore: unused, testMatch: '**/*.spec.ts' },
    { name: 'unused browser', use: { ...desktop, reuseContext: false }, testMatch: unused },
    { name: 'tablet', use: { ...tablet, hand: 'finger' }, testMatch: '**/*.touch.ts' },
  ],
})
