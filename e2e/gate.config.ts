import { defineConfig } from '@playwright/test'
import base from './playwright.config.ts'

/** `npm run test:gate`: one walk through the main path of every feature and page, for `npm test`. */
export default defineConfig({
  // Merged, the projects of the whole suite would walk too.
  ...base,
  testDir: 'gate',
  outputDir: 'test-results/gate',
  projects: [{ name: 'gate', use: { viewport: { width: 1366, height: 768 } } }],
})
