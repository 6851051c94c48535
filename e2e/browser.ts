import { chromium } from '@playwright/test'
import { ensureChromium } from './chromium.mjs'

/** What a Chromium needs to run in a container, and to talk to nobody but us. */
export const flags = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
]

/** A browser for pictures and benchmarks. */
export async function launchBrowser(more: readonly string[] = []) {
  return chromium.launch({ executablePath: await ensureChromium(), args: [...flags, ...more] })
}
