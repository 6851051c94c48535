import AxeBuilder from '@axe-core/playwright'
import { expect, type Page } from '@playwright/test'

// No rule that is on asks for the style sheets: to read them all again takes its time.
const options = { resultTypes: ['violations' as const], preload: { assets: ['media'] } }

/**
 * What axe finds, a line each: the rule and where. All rules look at everything; what they do not find wrong is not carried
 * out of the page, nor is a page opened to gather it, which takes four fifths of the time.
 */
export async function axeFindings(page: Page): Promise<string[]> {
  const there = await Promise.all(page.frames().map((frame) => frame.evaluate(() => 'axe' in globalThis)))
  // It stays in a document: half a megabyte of script is not read again for the next look.
  const again = there.every(Boolean) ? { axeSource: ';' } : {}
  const axe = new AxeBuilder({ page, ...again }).options(options).setLegacyMode(true)
  const { violations, passes } = await axe.analyze()
  expect(passes.length, 'rules that found something to look at').toBeGreaterThan(10)
  return violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target.join(' ')}`))
}
