import { chromium } from '@playwright/test'
import { flags } from '../packages/chromium/index.mjs'
import { ensureChromium } from './chromium.mjs'

export { flags }

/** A browser for pictures and benchmarks. */
export async function launchBrowser(more: readonly string[] = []) {
  return chromium.launch({ executablePath: await ensureChromium(), args: [...flags, ...more] })
}
