import { test as base } from '@playwright/test'
import { startServer } from '../scripts/server.ts'
import { Child } from './child.ts'
import type { Language } from './words.ts'

interface Wishes {
  /** Which language the browser asks for. */
  readonly language: Language
  readonly hand: 'mouse' | 'finger'
  readonly child: Child
}

interface Worker {
  /** Address of a server of our own, one a worker. */
  readonly house: string
}

/** Playwright's `test` against the built product; `page.goto('/')` is the home page. */
export const test = base.extend<Wishes, Worker>({
  house: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
    async ({}, use) => {
      const server = await startServer({ port: 0, host: '127.0.0.1' })
      await use(server.url)
      await server.close()
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ house }, use) => use(house),
  language: ['en', { option: true }],
  hand: ['mouse', { option: true }],
  locale: async ({ language }, use) => use({ en: 'en-GB', de: 'de-DE' }[language]),
  child: async ({ page, language, hand }, use) => use(new Child(page, language, hand)),
})

export { expect } from '@playwright/test'
