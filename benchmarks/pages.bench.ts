import { content } from '@botgarten/content/files'
import { launchBrowser } from '../e2e/browser.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import type { Table } from './bench.ts'
import { look, lookAtBadPage, type Looked } from './pages/look.ts'
import { tableOf } from './pages/table.ts'

/** All that is printed, looked at line by line. */
export default async function pages(): Promise<Table> {
  await buildWhenNeeded()
  const { items, languages } = content
  const cards = items.filter(({ paper }) => paper === 'a5')
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  await lookAtBadPage(browser)
  const all: Looked[] = []
  for (const language of languages) {
    all.push(...(await look(browser, server.url, items, language, 'a4')))
    all.push(...(await look(browser, server.url, cards, language, 'a5')))
  }
  await browser.close()
  await server.close()
  return tableOf(all)
}
