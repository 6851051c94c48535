import type { Browser } from '@playwright/test'
import type { Item } from '@botgarten/content/items'
import { badPage, overlooked } from './bad-page.ts'
import { address, findingsIn, printed } from './files.ts'
import { findingsOn, type Finding, type Least } from './findings.ts'
import { lookAtPaper } from './in-page.ts'
import type { SeenPaper } from './seen.ts'

/** What was looked at: an item in a language, on a paper. */
export interface Looked {
  readonly id: string
  readonly language: string
  readonly paper: string
  readonly pages: number
  /** In pt. */
  readonly smallest: number
  readonly findings: readonly Finding[]
}

const small: Least = { text: 7.5, drawn: 7 }
const window = { width: 1400, height: 900 }

/** On paper letters are read from the hand, on slides from the last row. */
const leastOf = ({ paper }: Item): Least => (paper === '16:9' ? { text: 12, drawn: 9 } : small)

/** Each in turn on a page as large as its paper, so that all of it lies under the pointer. */
async function papersOf(
  browser: Browser,
  baseURL: string,
  items: readonly Item[],
  language: string,
  paper: string,
) {
  const locale = language === 'de' ? 'de-DE' : 'en-GB'
  const context = await browser.newContext({ baseURL, locale, viewport: window })
  const page = await context.newPage()
  await page.emulateMedia({ media: 'print' })
  const seen: SeenPaper[] = []
  for (const { kind, id } of items) {
    await page.setViewportSize(window)
    await page.goto(`/materials/${kind}/${id}?${new URLSearchParams({ paper, address })}`)
    await page.locator('html[data-print=ready]').waitFor({ state: 'attached' })
    const height = await page.evaluate(() => document.documentElement.scrollHeight)
    await page.setViewportSize({ ...window, height: height + 40 })
    seen.push(await page.evaluate(lookAtPaper))
  }
  await context.close()
  return seen
}

/** @throws Error where something on a bad page is overlooked: then nothing can be said about the others. */
export async function lookAtBadPage(browser: Browser): Promise<void> {
  const page = await browser.newPage()
  await page.setContent(badPage)
  const seen = await page.evaluate(lookAtPaper)
  await page.close()
  const missed = overlooked(findingsOn(seen, small))
  if (missed.length > 0) throw new Error(`Overlooked: ${JSON.stringify(missed)}`)
}

/** Items in a language on a paper, as pages and as files. */
export async function look(
  browser: Browser,
  url: string,
  items: readonly Item[],
  language: string,
  paper: string,
): Promise<Looked[]> {
  const ids = items.map(({ id }) => id)
  const files = await printed(ids, language, paper)
  const papers = await papersOf(browser, url, items, language, paper)
  return items.map((item, index) => ({
    id: item.id,
    language,
    paper: item.paper === 'a5' ? paper : item.paper,
    pages: files[index]!.pages.length,
    smallest: Math.min(...papers[index]!.texts.map(({ points }) => points)),
    findings: [...findingsOn(papers[index]!, leastOf(item)), ...findingsIn(files[index]!, language)],
  }))
}
