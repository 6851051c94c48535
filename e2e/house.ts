import { expect, test as base, type BrowserContext } from '@playwright/test'
import { Child } from './child.ts'
import { serverWithData } from './class-server.ts'
import type { HandName } from './hand.ts'
import type { Language } from './words.ts'

interface Wishes {
  /** Which language the browser asks for. */
  readonly language: Language
  readonly hand: HandName
  /** Nobody has used this browser yet: the tour is offered. */
  readonly newcomer: boolean
  /** Does the screen move as it does for most children? Waiting for it takes time where a test is about something else. */
  readonly motion: boolean
  readonly child: Child
  /** What the browser may complain about here, because the test asks for it. */
  readonly complaints: readonly RegExp[]
  /** Ends every test that asked another host for anything, or during which a page logged or threw an error. */
  readonly quiet: void
}

interface Worker {
  /** Address of a server of our own, one a worker. */
  readonly house: string
}

/** Everything that must not happen in any page of a context, as it happens. */
function listen(context: BrowserContext, house: string): readonly string[] {
  const heard: string[] = []
  context.on('console', (message) => message.type() === 'error' && heard.push(message.text()))
  context.on('weberror', (error) => heard.push(error.error().message))
  context.on('request', (request) => {
    if (/^(https?|wss?):/.test(request.url()) && !request.url().startsWith(`${house}/`))
      heard.push(`A request to ${request.url()}`)
  })
  return heard
}

/** Playwright's `test` against the built product; `page.goto('/')` is the home page. */
export const test = base.extend<Wishes, Worker>({
  house: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
    async ({}, use) => {
      const server = await serverWithData()
      await use(server.url)
      await server.close()
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ house }, use) => use(house),
  language: ['en', { option: true }],
  hand: ['mouse', { option: true }],
  newcomer: [false, { option: true }],
  context: async ({ context, newcomer }, use) => {
    if (!newcomer)
      await context.addInitScript(() => {
        try {
          localStorage.setItem('botgarten.tour', '"seen"')
        } catch {
          // A browser that keeps nothing offers the tour every time.
        }
      })
    await use(context)
    // What Playwright leaves when the context serves another test.
    await context.clearPermissions()
  },
  motion: [false, { option: true }],
  contextOptions: async ({ motion }, use) => use(motion ? {} : { reducedMotion: 'reduce' }),
  locale: async ({ language }, use) => use({ en: 'en-GB', de: 'de-DE' }[language]),
  child: async ({ page, language, hand }, use) => use(new Child(page, language, hand)),
  complaints: [[], { option: true }],
  quiet: [
    async ({ context, house, complaints }, use) => {
      const heard = listen(context, house)
      await use()
      expect(heard.filter((text) => !complaints.some((known) => known.test(text)))).toEqual([])
    },
    { auto: true },
  ],
})

export { expect } from '@playwright/test'
