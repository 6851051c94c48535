import type { Page } from '@playwright/test'
import { build } from 'vite'
import type { Outcome } from './runs.ts'

async function bundle(): Promise<string> {
  const entry = new URL('runs.ts', import.meta.url).pathname
  const lib = { entry, formats: ['iife' as const], name: 'runs' }
  const made = await build({
    ...{ configFile: false as const, logLevel: 'error' as const },
    build: { write: false, minify: false, target: 'es2022', lib },
  })
  const [output] = Array.isArray(made) ? made : [made]
  if (output === undefined || !('output' in output)) throw new Error('The programs could not be bundled.')
  return output.output[0].code
}

/** The outcomes of the same code in a browser. */
export async function outcomesIn(page: Page): Promise<Outcome[]> {
  await page.addScriptTag({ content: await bundle() })
  return page.evaluate(() => (globalThis as unknown as { runs: { outcomes(): Outcome[] } }).runs.outcomes())
}
