import AxeBuilder from '@axe-core/playwright'
import { expect, test, type Page } from '@playwright/test'
import type { Child } from './child.ts'
import { atBorder } from './dialog-border.ts'

// No rule that is on asks for the style sheets: to read them all again takes its time.
const options = { resultTypes: ['violations' as const], preload: { assets: ['media'] } }

/**
 * Violations that axe finds, a line each: the rule and the element. Passes are not carried out of the page, nor is a page
 * opened to gather them, which takes four fifths of the time.
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

/** Waits for transitions: half-way through a fade colours differ from the final ones. */
const settles = (page: Page) =>
  page.evaluate(async () => {
    const ending = document
      .getAnimations()
      .filter(({ effect }) => effect?.getComputedTiming().endTime !== Infinity)
    await Promise.allSettled(ending.map(({ finished }) => finished))
  })

/** States of screens by their names, in an order: each begins where the one before it ends. `phone`: below 640 px. */
export interface States {
  readonly [state: string]: (child: Child, phone: boolean) => Promise<unknown>
}

/** Goes from state to state; axe must find nothing in any of them, and nothing may touch the border of a dialog. @param more other faults of a page, a line each */
export async function findsNothing(
  child: Child,
  states: States,
  more: (page: Page) => Promise<readonly string[]> = () => Promise.resolve([]),
) {
  const { page } = child
  const found: { [state: string]: string[] } = {}
  for (const [state, show] of Object.entries(states))
    await test.step(state, async () => {
      await show(child, page.viewportSize()!.width < 640)
      await settles(page)
      found[state] = [...(await more(page)), ...(await atBorder(page)), ...(await axeFindings(page))]
    })
  expect(found).toEqual(Object.fromEntries(Object.keys(states).map((state) => [state, []])))
}
