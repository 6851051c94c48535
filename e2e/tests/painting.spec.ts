// Rooms: world, network
import type { Browser, BrowserContextOptions, Page } from '@playwright/test'
import { Child, leftEye, leftWheel } from '../child.ts'
import { expect, test } from '../house.ts'

const screens: readonly (BrowserContextOptions & { readonly name: string })[] = [
  { name: 'twice as many pixels', deviceScaleFactor: 2 },
  { name: 'three times as many', deviceScaleFactor: 3 },
  { name: 'forced colours on an ordinary screen', forcedColors: 'active' },
]

/** A lab whose canvases are painted by a worker, or by the page as in browsers without one. */
async function labOn(browser: Browser, options: BrowserContextOptions, isWorker: boolean): Promise<Child> {
  const context = await browser.newContext({ locale: 'en-GB', reducedMotion: 'reduce', ...options })
  await context.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
  if (!isWorker)
    await context.addInitScript(() =>
      Reflect.deleteProperty(HTMLCanvasElement.prototype, 'transferControlToOffscreen'),
    )
  const child = new Child(await context.newPage(), 'en')
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.6)
  await child.steps('stepNetwork')
  return child
}

const panes = ['.world > canvas', '.stage canvas:not(.back)']

/** The share of pixels that differ clearly, and how many colours the first picture has. */
function compare(page: Page, one: string, other: string) {
  return page.evaluate(
    async (addresses) => {
      const [a, b] = await Promise.all(
        addresses.map(async (src) => {
          const image = Object.assign(new Image(), { src })
          await image.decode()
          const { width, height } = image
          const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d')!
          context.drawImage(image, 0, 0)
          return context.getImageData(0, 0, width, height)
        }),
      )
      if (a!.width !== b!.width || a!.height !== b!.height) return { differs: 1, colours: 0 }
      const colours = new Set<number>()
      let different = 0
      for (let i = 0; i < a!.data.length; i += 4) {
        const off = [0, 1, 2, 3].map((k) => Math.abs(a!.data[i + k]! - b!.data[i + k]!))
        if (Math.max(...off) > 32) different += 1
        colours.add((a!.data[i]! << 16) | (a!.data[i + 1]! << 8) | a!.data[i + 2]!)
      }
      return { differs: different / (a!.data.length / 4), colours: colours.size }
    },
    [one, other],
  )
}

for (const { name, ...options } of screens)
  test(`a worker paints to the pixel what the page paints: ${name}`, async ({ browser, house }) => {
    const labs = [
      await labOn(browser, { baseURL: house, ...options }, true),
      await labOn(browser, { baseURL: house, ...options }, false),
    ] as const
    for (const pane of panes) {
      const pictures = () => Promise.all(labs.map((child) => child.painted.drawing(child.page.locator(pane))))
      // Letters may come a little later to one of the two.
      await expect
        .poll(async () => {
          const [one, other] = (await pictures()) as [string, string]
          const { differs, colours } = await compare(labs[0].page, one, other)
          return colours > 50 ? differs : 1
        })
        .toBeLessThan(0.001)
    }
    const density = await labs[0].page
      .locator(panes[0]!)
      .evaluate((one) => (one as HTMLCanvasElement).width / one.clientWidth)
    expect(density).toBeCloseTo(options.deviceScaleFactor ?? 1, 1)
    await Promise.all(labs.map((child) => child.page.context().close()))
  })

test.describe('where the worker does not come', () => {
  test.use({ complaints: [/worker/i, /Failed to load resource/] })

  test('the page paints by itself', async ({ child, page }) => {
    await page.route(/worker[^/]*\.js$/, (route) => route.abort())
    await child.opensLab('friendship')
    const colours = () => child.painted.drawing(page.locator('.world > canvas'))
    const before = await colours()
    expect(before.length).toBeGreaterThan(5000)
    await child.typesWeight(leftEye, leftWheel, 0.6)
    await child.pressesStart()
    await expect.poll(colours).not.toBe(before)
  })
})
