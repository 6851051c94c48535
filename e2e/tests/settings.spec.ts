// Rooms: home, app
import { opensSettings, option } from '../child-cards.ts'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { givesVoice, said } from '../voice.ts'
import { languagesOf } from '../words.ts'

const reads = (child: Child, what: string) =>
  child.presses('comfort.read', { what: child.word(`comfort.${what}`) })

const fontOf = (child: Child) =>
  child.page.locator('h1').evaluate((title) => getComputedStyle(title).fontFamily)

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`in ${language}`, () => {
    test.use({ language })

    test('what is switched on stays on: at home, in the lab, after loading again', async ({
      child,
      page,
    }) => {
      await child.opensHome()
      await opensSettings(child, 'home')
      for (const name of ['projector', 'quiet', 'letters'] as const) {
        await option(child, name).focus()
        await child.types('Space')
        await expect(option(child, name)).toBeChecked()
      }
      await child.types('Escape')
      await child.opensLab('friendship')
      await expect(page.locator('html')).toHaveAttribute('data-projector')
      await expect.poll(() => fontOf(child)).toContain('Atkinson')
      await expect(page.locator('.strip .peek')).toBeHidden()
      await expect(page.locator('.strip .piep')).toBeHidden()
      await expect(child.button('lab.hint')).toBeVisible()
      await opensSettings(child, 'lab')
      await option(child, 'quiet').click()
      await child.types('Escape')
      await expect(page.locator('.strip .peek')).toBeVisible()
    })

    test('clear letters travel only when they are switched on, and reach the blocks', async ({
      child,
      page,
    }) => {
      const fonts: string[] = []
      page.on('request', (request) => {
        if (request.url().includes('atkinson')) fonts.push(request.url())
      })
      await child.opensLab('friendship')
      expect(fonts).toEqual([])
      const width = () =>
        child.block('wheelLeft').evaluate((block) => (block as SVGGraphicsElement).getBBox().width)
      const before = await width()
      const words = await child.blockWords()
      await opensSettings(child, 'lab')
      await option(child, 'letters').click()
      await child.types('Escape')
      await expect.poll(width).not.toBe(before)
      expect(fonts.length).toBeGreaterThan(0)
      await expect.poll(() => child.blockWords()).toEqual(words)
      const font = await child
        .block('eyeLeft')
        .locator('text')
        .first()
        .evaluate((text) => getComputedStyle(text).fontFamily)
      expect(font).toContain('Atkinson')
    })

    test('blocks and words grow for the wall; nothing is cut', async ({ child, page }) => {
      await child.opensLab('friendship')
      const height = async () => (await child.block('wheelLeft').boundingBox())!.height
      const before = await height()
      await opensSettings(child, 'lab')
      await option(child, 'projector').click()
      await child.types('Escape')
      await expect.poll(height).toBeGreaterThan(before * 1.2)
      const sideways = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
      expect(sideways).toBeLessThanOrEqual(0)
    })

    test('task, card, hint and blocks are read aloud in the language of now', async ({ child, page }) => {
      await givesVoice(child.page, ['de-DE', 'en-GB'])
      await child.opensLab('friendship')
      await expect(child.button('comfort.read', { what: child.word('comfort.theTask') })).toHaveCount(0)
      await opensSettings(child, 'lab')
      await option(child, 'aloud').click()
      await child.types('Escape')
      await reads(child, 'theTask')
      await child.presses('lab.card')
      await reads(child, 'theCard')
      await child.types('Escape')
      await child.presses('lab.hint')
      await reads(child, 'theHint')
      await child
        .block('eyeLeft')
        .locator('.blocklyPath')
        .first()
        .click({ position: { x: 8, y: 14 } })
      await reads(child, 'theBlock')
      await expect.poll(() => said(page)).toHaveLength(4)
      const heard = await said(page)
      expect(heard[1]).toContain(await page.getByRole('heading', { level: 1 }).innerText())
      expect(heard[3]).toBe(child.word('block.ai_nn_input_node_ultrasonic.help'))
      const spot = await child.middleOf(child.block('eyeLeft').locator('text').first())
      await page.mouse.move(spot.x, spot.y)
      await page.mouse.down()
      await expect.poll(async () => (await said(page)).length).toBe(5)
      await page.mouse.up()
    })

    test('a device without a voice says so', async ({ child, page }) => {
      await givesVoice(child.page, ['fr-FR'])
      await child.opensLab('friendship')
      await opensSettings(child, 'lab')
      await option(child, 'aloud').click()
      await child.types('Escape')
      await reads(child, 'theTask')
      await expect(page.getByText(child.word('comfort.noVoice'))).toBeVisible()
      await expect.poll(() => said(page)).toEqual([])
    })

    test('the sound switch is kept', async ({ child }) => {
      await child.opensLab('friendship')
      await child.presses('lab.soundOff')
      await child.reloads()
      await expect(child.button('lab.soundOn').first()).toBeVisible()
    })

    test('broken settings on the device are no settings', async ({ child, page }) => {
      await page.addInitScript(() => {
        localStorage.setItem('botgarten.comfort', '{"projector":"yes","letters":')
        localStorage.setItem('botgarten.sound', '"loud"')
      })
      await child.opensHome()
      await expect(page.locator('html')).not.toHaveAttribute('data-projector')
      await child.opensLab('fear')
      await expect(child.button('lab.soundOff').first()).toBeVisible()
    })
  })
}
