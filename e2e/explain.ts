// `npm run explain`: the pictures of sheet 4.3 from the lab as it is now, with its numbers and arrows.
import { writeFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { serverWithData } from './class-server.ts'
import { launchBrowser } from './browser.ts'
import { Child } from './child.ts'
import { explainedPlaces, learnsABit, pictured, showsExplained, viewport } from './explained-lab.ts'
import { explainedPicture } from './explained-picture.ts'
import { languages } from './words.ts'

await buildWhenNeeded()
const server = await serverWithData()
const browser = await launchBrowser()
try {
  for (const language of languages) {
    const locale = { en: 'en-GB', de: 'de-DE' }[language]
    const context = await browser.newContext({
      ...{ baseURL: server.url, locale, viewport, deviceScaleFactor: 1 },
      reducedMotion: 'reduce',
    })
    await context.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
    const child = new Child(await context.newPage(), language)
    await showsExplained(child)
    await learnsABit(child)
    const screen = await child.page.screenshot({ type: 'jpeg', quality: 65, clip: pictured })
    const svg = explainedPicture(screen, await explainedPlaces(child))
    writeFileSync(content.path(content.itemFolder('q-map'), `screen-${language}.svg`), svg)
    await context.close()
  }
} finally {
  await browser.close()
  await server.close()
}
