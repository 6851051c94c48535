import type { Page } from '@playwright/test'
import { build } from 'vite'
import type { Outcome } from './runs.ts'

/** A file and all that it imports as one script, which gives its exports to the page under `name`. */
export async function bundle(file: URL, name: string): Promise<string> {
  const lib = { entry: file.pathname, formats: ['iife' as const], name }
  const made = await build({
    ...{ configFile: false as const, logLevel: 'error' as const },
    build: { write: false, minify: false, target: 'es2022', lib },
  })
  const [output] = Array.isArray(made) ? made : [made]
  if (output === undefined || !('output' in output)) throw new Error('The programs could not be bundled.')
  return output.output[0].code
}

/** The outcomes of the same code in a browser. */
export async function outcomesIn(page: Page, some: readonly string[]): Promise<Outcome[]> {
  await page.addScriptTag({ content: await bundle(new URL('runs.ts', import.meta.url), 'runs') })
  return page.evaluate(
    (names) => (globalThis as unknown as { runs: typeof import('./runs.ts') }).runs.outcomes(names),
    some,
  )
}
