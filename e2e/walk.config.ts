import { defineConfig } from '@playwright/test'
import base from './playwright.config.ts'

/** `npm run walk`: everything to its end, in a browser. Long by nature, so it is no part of `npm test`. */
export default defineConfig(base, {
  testDir: 'walk',
  timeout: 600_000,
  projects: [{ name: 'walk', use: { viewport: { width: 1366, height: 768 } }, testMatch: '**/*.walk.ts' }],
})
