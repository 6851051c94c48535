import { test as base } from '@playwright/test'
import { startServer } from '../scripts/server.ts'

interface Worker {
  /** Address of a server of our own, one a worker. */
  readonly house: string
}

/** Playwright's `test` against the built product; `page.goto('/')` is the home page. */
export const test = base.extend<object, Worker>({
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
})

export { expect } from '@playwright/test'
