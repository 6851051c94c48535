import type { Browser } from '@playwright/test'
import { readItem, type Item } from '@botgarten/materials/items'
import { launchBrowser } from '../e2e/browser.ts'
import { itemFolders, languages, read } from '../packages/materials/items/testing/catalogue.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import type { Table } from './bench.ts'
import { exceptionFor, exceptions } from './pages/exceptions.ts'
import { badPage, overlooked } from './pages/bad-page.ts'
import { address, findingsIn, printed } from './pages/files.ts'
import { findingsOn, kinds, type Finding, type Least } from './pages/findings.ts'
import { lookAtPaper } from './pages/in-page.ts'
import type { SeenPaper } from './pages/seen.ts'

/** What was looked at: an item in a language, on a paper. */
interface Looked {
  readonly item: Item
  readonly language: string
  readonly paper: string
  readonly pages: number
  readonly smallest: number
  readonly findings: readonly Finding[]
}

const items = itemFolders.map((folder) => readItem(read(folder, 'item.json')))
const cards = items.filter(({ paper }) => paper === 'a5')

/** On paper letters are read from the hand, on slides from the last row. */
const leastOf = ({ paper }: Item): Least =>
  paper === '16:9' ? { text: 12, drawn: 9 } : { text: 7.5, drawn: 7 }

/** Each in turn on a page as large as its paper, so that all of it lies under the pointer. */
async function look(
  browser: Browser,
  baseURL: string,
  language: string,
  paper: string,
  some: readonly Item[],
) {
  const locale = language === 'de' ? 'de-DE' : 'en-GB'
  const context = await browser.newContext({ baseURL, locale, viewport: { width: 1400, height: 900 } })
  const page = await context.newPage()
  await page.emulateMedia({ media: 'print' })
  const seen: SeenPaper[] = []
  for (const { kind, id } of some) {
    await page.setViewportSize({ width: 1400, height: 900 })
    await page.goto(`/materials/${kind}/${id}?${new URLSearchParams({ paper, address })}`)
    await page.locator('html[data-print=ready]').waitFor({ state: 'attached' })
    const height = await page.evaluate(() => document.documentElement.scrollHeight)
    await page.setViewportSize({ width: 1400, height: height + 40 })
    seen.push(await page.evaluate(lookAtPaper))
  }
  await context.close()
  return seen
}

/** Whoever overlooks what is wrong on a bad page has nothing to say about the others. */
async function seesWhatIsWrong(browser: Browser): Promise<void> {
  const page = await browser.newPage()
  await page.setContent(badPage)
  const seen = await page.evaluate(lookAtPaper)
  await page.close()
  const missed = overlooked(findingsOn(seen, { text: 7.5, drawn: 7 }))
  if (missed.length > 0) throw new Error(`Overlooked: ${JSON.stringify(missed)}`)
}

async function lookAndRead(
  browser: Browser,
  url: string,
  language: string,
  paper: string,
): Promise<Looked[]> {
  const some = paper === 'a4' ? items : cards
  const files = await printed(
    some.map(({ id }) => id),
    language,
    paper,
  )
  const papers = await look(browser, url, language, paper, some)
  return some.map((item, index) => ({
    item,
    language,
    paper: item.paper === 'a5' ? paper : item.paper,
    pages: files[index]!.pages.length,
    smallest: Math.min(...papers[index]!.texts.map(({ points }) => points)),
    findings: [...findingsOn(papers[index]!, leastOf(item)), ...findingsIn(files[index]!, language)],
  }))
}

function rowOf({ item, language, paper, pages, smallest, findings }: Looked) {
  const open = findings.filter((finding) => !exceptionFor(item.id, finding))
  const counts = kinds.map((kind) => open.filter((finding) => finding.kind === kind).length || '–')
  const size = Number.isFinite(smallest) ? `${smallest.toFixed(1)} pt` : '–'
  return [item.id, language, paper, pages, ...counts, size, findings.length - open.length || '–']
}

/** All that is printed, looked at line by line. */
export default async function pages(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  await seesWhatIsWrong(browser)
  const looked: Looked[] = []
  for (const language of languages)
    for (const paper of ['a4', 'a5'])
      looked.push(...(await lookAndRead(browser, server.url, language, paper)))
  await browser.close()
  await server.close()
  const open = looked.flatMap(({ item, language, paper, findings }) =>
    findings
      .filter((finding) => !exceptionFor(item.id, finding))
      .map(({ kind, what }) => `${item.id}, ${language}, ${paper}: ${kind}: ${what}`),
  )
  return {
    title: 'Every printed page, looked at',
    how: 'Each item’s page in print media, in both languages and on its papers, measured line by line in Chromium; and the files of `botgarten print`, read back.',
    columns: ['item', 'language', 'paper', 'pages', ...kinds, 'smallest letters', 'meant to be so'],
    rows: looked.map(rowOf),
    notes: [
      'overlap: lines or pictures over each other · cut: what leaves its box, its drawing or its paper · empty: a box with nothing in it · language: words of the other language · pale: contrast in luminance below 4.5 : 1, large letters below 3 : 1, so in grey as well · small: letters below 7.5 pt (7 in drawings; on slides 12 and 9) · file: tags, language, title, outline, words for figures, levels of headings, fonts, pages without marks.',
      ...exceptions.map(
        ({ kind, items, what, because }) =>
          `Meant to be so (${kind}, ${items?.join(', ') ?? 'everywhere'}, ${what.source}): ${because}`,
      ),
      ...(open.length > 0 ? open : ['Nothing is open.']),
    ],
  }
}
