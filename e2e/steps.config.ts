import { defineConfig } from '@playwright/test'
import gate from './gate.config.ts'

/** `npm run test:steps`: every control of every feature is used once, and the page changes as a file lists. */
export default defineConfig({ ...gate, testDir: 'steps', outputDir: 'test-results/steps' })
