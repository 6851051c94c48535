// `npm run pictures`: every screen in both languages at three sizes, into pictures/.
import { mkdirSync } from 'node:fs'
import type { Browser, Page } from '@playwright/test'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { inHouse } from '../scripts/prepare/house.mjs'
import { startServer } from '../scripts/server.ts'
import { launchBrowser } from './browser.ts'
import { Child } from './child.ts'
import { classOfTest, serverWithData } from './class-server.ts'
import { pupilScreens, type ClassScreen } from './screens-class.ts'
import { startScreens, type StartScreen } from './screens-start.ts'
import { teacherScreens } from './screens-teacher.ts'
import { screens, type Screen } from './screens.ts'
import { languages, type Language } from './words.ts'

const sizes = [
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
]
type Size = (typeof sizes)[number]
const isPhone = ({ width }: Size) => width < 640
const folder = inHouse('pictures')
/** As a machine in a room has it. */
const announced = 'http://192.168.0.5:4173'

/** A server, and how its page comes to what is wanted. */
interface Stage {
  readonly url: string
  show(child: Child, phone: boolean): Promise<void>
  close(): Promise<void>
}

interface Wish {
  readonly name: string
  readonly language: Language
  readonly size: Size
  opens: () => Promise<Stage>
}

/** Fonts, pictures and the painter of canvases are there, and nothing moves that comes to an end. */
async function settles(page: Page) {
  await page.waitForLoadState('networkidle')
  await page.evaluate(async () => {
    for (let frames = 3; frames > 0; frames -= 1) await new Promise(requestAnimationFrame)
    await document.fonts.ready
    const ending = document
      .getAnimations()
      .filter(({ effect }) => effect?.getComputedTiming().endTime !== Infinity)
    await Promise.allSettled(ending.map(({ finished }) => finished))
  })
}

async function take(browser: Browser, { name, language, size, opens }: Wish) {
  const stage = await opens()
  const locale = { en: 'en-GB', de: 'de-DE' }[language]
  const options = { baseURL: stage.url, locale, viewport: size, hasTouch: size.width < 1366 }
  const context = await browser.newContext(options)
  try {
    await context.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
    const page = await context.newPage()
    await stage.show(new Child(page, language), isPhone(size))
    await settles(page)
    await page.screenshot({ path: `${folder}/${name}-${language}-${size.width}x${size.height}.png` })
  } finally {
    await context.close()
    await stage.close()
  }
}

await buildWhenNeeded()
mkdirSync(folder, { recursive: true })
const server = await startServer({ port: 0, host: '127.0.0.1' })
const browser = await launchBrowser()

const inLab = (screen: Screen): Wish[] =>
  languages.flatMap((language) =>
    sizes
      .filter((size) => (isPhone(size) ? !screen.neverPhone : !screen.phoneOnly))
      .map((size) => ({
        ...{ name: screen.name, language, size },
        opens: () =>
          Promise.resolve({
            url: server.url,
            show: (child, phone) => screen.show(child, phone),
            close: () => Promise.resolve(),
          }),
      })),
  )

/** Every picture has a class of its own: what one shows changes no other. */
const inClass = (screen: ClassScreen): Wish[] =>
  languages.flatMap((language) =>
    [...sizes.filter((size) => !screen.neverPhone || !isPhone(size)), ...(screen.more ?? [])].map((size) => ({
      ...{ name: screen.name, language, size },
      opens: async () => {
        const made = await classOfTest(language, announced)
        return { ...made, show: (child) => screen.show(child, made) }
      },
    })),
  )

const beforeAll = (screen: StartScreen): Wish[] =>
  languages.flatMap((language) =>
    sizes
      .filter((size) => !isPhone(size))
      .map((size) => ({
        ...{ name: screen.name, language, size },
        opens: async () => {
          const empty = await serverWithData(announced)
          return { ...empty, show: (child) => screen.show(child, empty) }
        },
      })),
  )

const wanted = process.argv.slice(2)
const wishes = [
  ...screens.flatMap(inLab),
  ...[...pupilScreens, ...teacherScreens].flatMap(inClass),
  ...startScreens.flatMap(beforeAll),
].filter(({ name }) => wanted.length === 0 || wanted.some((part) => name.includes(part)))
const missing: string[] = []
for (const wish of wishes)
  await take(browser, wish).catch((cause: unknown) => {
    const [what] = String(cause).split('\n\nCall log')
    missing.push(`${wish.name} ${wish.language} ${wish.size.width}: ${what}`)
  })
console.log(`${wishes.length - missing.length} of ${wishes.length} pictures in ${folder}`)
for (const line of missing) console.error(line)
await browser.close()
await server.close()
process.exitCode = missing.length === 0 ? 0 : 1
