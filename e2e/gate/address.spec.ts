import { readFileSync } from 'node:fs'
import { Child, leftEye, leftWheel } from '../child.ts'
import { serverWithData } from '../class-server.ts'
import { expect, opensCard, test } from './gate.ts'

/** A server that announces another name than the one it is opened by. Browsers resolve both to this machine. */
const announced = 'http://garden.localhost:4173'

test.use({ language: 'en', complaints: [/^A request to http:\/\/laptop\.localhost:\d+\//] })

test(
  'under an old address the way to the announced one is shown, and work made there is taken along as a file',
  {
    tag: '@address',
  },
  async ({ browser, contextOptions, language, locale }) => {
    const server = await serverWithData(announced)
    const context = await browser.newContext({
      ...contextOptions,
      ...{ baseURL: `http://laptop.localhost:${server.port}`, locale },
    })
    await context.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
    const child = new Child(await context.newPage(), language)
    await child.page.goto('/')
    const sheet = child.page.getByRole('dialog')
    await expect(sheet).toContainText(child.word('address.nothing'))
    const go = sheet.getByRole('link', { name: child.word('address.go') })
    await expect(go).toHaveAttribute('href', new RegExp(`^${announced}`))
    await child.presses('address.stay')
    await opensCard(child, 'friendship')
    await child.typesWeight(leftEye, leftWheel, 0.7)
    await child.seesSaved()

    const next = new Child(await context.newPage(), language)
    await next.page.goto('/')
    await expect(next.page.getByRole('dialog')).toContainText(next.word('address.alone', { count: 1 }))
    const [file] = await Promise.all([next.page.waitForEvent('download'), next.presses('address.takeHome')])
    expect(readFileSync(await file.path(), 'utf8')).toContain('"eyeLeft":{"wheelLeft":0.7')
    await expect(next.page.getByRole('dialog')).toContainText(next.word('address.taken'))
    await context.close()
    await server.close()
  },
)
