// `npm run pictures`: every screen in both languages at three sizes, into pictures/.
import { mkdirSync } from 'node:fs'
import type { Browser, Page } from '@playwright/test'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { inHouse } from '../scripts/prepare/house.mjs'
import { startServer } from '../scripts/server.ts'
import { launchBrowser } from './browser.ts'
import { Child } from './child.ts'
import { screens, type Screen } from './screens.ts'
import { languages, type Language } from './words.ts'

const sizes = [
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
]
const isPhone = ({ width }: { readonly width: number }) => width < 640
const folder = inHouse('pictures')

interface Wish {
  readonly screen: Screen
  readonly language: Language
  readonly size: { readonly width: number; readonly height: number }
}

/** Fonts are there, and nothing moves that comes to an end. */
async function settles(page: Page) {
  await page.evaluate(async () => {
    await document.fonts.ready
    const ending = document
      .getAnimations()
      .filter(({ effect }) => effect?.getComputedTiming().endTime !== Infinity)
    await Promise.allSettled(ending.map(({ finished }) => finished))
  })
}

async function take(browser: Browser, baseURL: string, { screen, language, size }: Wish) {
  const locale = { en: 'en-GB', de: 'de-DE' }[language]
  const context = await browser.newContext({ baseURL, locale, viewport: size, hasTouch: size.width < 1366 })
  await context.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
  const page = await context.newPage()
  await screen.show(new Child(page, language), isPhone(size))
  await settles(page)
  await page.screenshot({ path: `${folder}/${screen.name}-${language}-${size.width}x${size.height}.png` })
  await context.close()
}

await buildWhenNeeded()
mkdirSync(folder, { recursive: true })
const server = await startServer({ port: 0, host: '127.0.0.1' })
const browser = await launchBrowser()
const wanted = process.argv.slice(2)
const requests = screens
  .filter(({ name }) => wanted.length === 0 || wanted.some((part) => name.includes(part)))
  .flatMap((screen) => languages.flatMap((language) => sizes.map((size) => ({ screen, language, size }))))
  .filter(({ screen, size }) => (isPhone(size) ? !screen.neverPhone : !screen.phoneOnly))
const missing: string[] = []
for (const request of requests)
  await take(browser, server.url, request).catch((cause: unknown) => {
    const [what] = String(cause).split('\n\nCall log')
    missing.push(`${request.screen.name} ${request.language} ${request.size.width}: ${what}`)
  })
console.log(`${requests.length - missing.length} of ${requests.length} pictures in ${folder}`)
for (const line of missing) console.error(line)
await browser.close()
await server.close()
process.exitCode = missing.length === 0 ? 0 : 1
