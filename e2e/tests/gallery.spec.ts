// Rooms: gallery, class, teacher
import { readFileSync } from 'node:fs'
import { isLong } from '@botgarten/numbers/testing'
import { parseProject } from '@botgarten/programs'
import { Pupil } from '../child-class.ts'
import { GalleryHands, sharesOne } from '../child-gallery.ts'
import { ProjectList } from '../child-projects.ts'
import { Child, leftEye, leftWheel } from '../child.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { anotherClass, joins, saves, signsIn, teaches } from '../made-class.ts'
import { languagesOf } from '../words.ts'

const test = testInClass()
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the gallery of a class, in ${language}`, () => {
    test.use({ language })

    test('by keys a child finds it, gives a heart, watches, remixes and shares', async ({
      browser,
      child,
      contextOptions,
      house,
      locale,
      page,
      school: server,
    }) => {
      const school = await anotherClass(server)
      const [fox, owl] = [await joins(school, 'Fuchs'), await joins(school, 'Eule')]
      await sharesOne(owl, 'Slow and safe')
      await signsIn(page, school, fox)
      const gallery = new GalleryHands(child)

      await test.step('home leads there', async () => {
        await child.opensHome()
        await page.getByRole('link', { name: child.word('class.gallery') }).focus()
        await page.keyboard.press('Enter')
        await expect(gallery.titles).toHaveText(['Slow and safe'])
      })
      await test.step('a heart, taken back and given again', async () => {
        await child.tabsTo(gallery.heart('Slow and safe', 0))
        await page.keyboard.press('Space')
        await expect(gallery.heart('Slow and safe', 1)).toHaveAttribute('aria-pressed', 'true')
        await page.keyboard.press('Space')
        await expect(gallery.heart('Slow and safe', 0)).toBeVisible()
        await page.keyboard.press('Space')
        await expect(gallery.heart('Slow and safe', 1)).toBeVisible()
      })
      await test.step('what others do is seen without loading the page again', async () => {
        const hare = await joins(school, 'Hase')
        const id = await sharesOne(hare, 'Rude')
        await expect(gallery.titles).toHaveText(['Rude', 'Slow and safe'])
        await owl.asker.ask('PUT', `/gallery/${id}/heart`, { on: true })
        await expect(gallery.heart('Rude', 1)).toBeVisible()
        await school.teacher.ask('PUT', `/classes/${school.id}/gallery/${id}`, { hidden: true })
        await expect(gallery.titles).toHaveText(['Slow and safe'])
      })
      await test.step('it drives on the page, fast, and goes back to its start', async () => {
        await page.getByRole('button', { name: 'Slow and safe', exact: true }).focus()
        await page.keyboard.press('Enter')
        await expect(gallery.looked.getByRole('heading', { name: 'Slow and safe' })).toBeFocused()
        const start = await gallery.place()
        await expect(child.button('gallery.watch')).not.toHaveAttribute('aria-disabled')
        await gallery.looked.getByLabel(child.word('gallery.speed')).selectOption('16')
        await child.tabsAndPresses('gallery.watch')
        await expect.poll(gallery.place).not.toEqual(start)
        await child.tabsAndPresses('gallery.toStart')
        await expect.poll(gallery.place).toEqual(start)
      })
      await test.step('a remix is a copy in the lab', async () => {
        await child.tabsAndPresses('gallery.remix')
        await child.seesLab()
        await child.seesWeight(leftEye, leftWheel, 0.8)
        await child.typesWeight(leftEye, leftWheel, 0.5)
      })
      await test.step('what was made from it is shared with its chain', async () => {
        await child.presses('lab.menu')
        await child.presses('parts.shareInClass')
        const dialog = page.getByRole('dialog')
        await dialog.getByLabel(child.word('gallery.title')).fill('Rally, fast one')
        await page.keyboard.press('Enter')
        await expect(child.words('gallery.shared')).toBeVisible()
        await gallery.opens()
        await child.presses('gallery.mine')
        await expect(gallery.titles).toHaveText(['Rally, fast one'])
        await gallery.looks('Rally, fast one')
        await expect(gallery.looked.getByRole('listitem')).toContainText([
          child.card('friendship'),
          'Slow and safe',
          'Rally, fast one',
        ])
        await expect(gallery.looked).toContainText('Eule')
      })
      await test.step('its file has titles, no nickname, and opens where there is no class', async () => {
        const [download] = await Promise.all([page.waitForEvent('download'), child.presses('gallery.file')])
        const text = readFileSync(await download.path(), 'utf8')
        expect(parseProject(text).madeFrom).toMatchObject([{ title: 'Slow and safe' }])
        for (const name of ['Fuchs', 'Eule']) expect(text).not.toContain(name)
        const elsewhere = await browser.newContext({ ...contextOptions, baseURL: house, locale })
        const friend = new Child(await elsewhere.newPage(), language)
        await friend.opensHome()
        await friend.opensFileAtHome('fast.botgarten.json', text)
        await friend.seesLab()
        await friend.seesWeight(leftEye, leftWheel, 0.5)
        await elsewhere.close()
      })
    })

    test('a brain alone goes into the own project, and another one races beside it', async ({
      child,
      page,
      school: server,
    }) => {
      const school = await anotherClass(server)
      const [fox, owl] = [await joins(school, 'Fuchs'), await joins(school, 'Eule')]
      await sharesOne(owl, 'Shy Bo')
      await saves(fox, { program: 'start', starts: [] })
      await signsIn(page, school, fox)
      const gallery = new GalleryHands(child)
      await child.opensLab('friendship')
      await child.seesWeight(leftEye, leftWheel, 0)

      await test.step('take the brain', async () => {
        await gallery.opens()
        await gallery.looks('Shy Bo')
        await child.presses('gallery.takeBrain')
        const dialog = page.getByRole('dialog')
        await dialog.getByText('Friendship', { exact: true }).click()
        await dialog.getByRole('button', { name: child.word('gallery.takeBrain') }).click()
        await child.seesLab()
        await child.seesWeight(leftEye, leftWheel, 0.8)
      })
      await test.step('a ghost of one’s own drives on the same floor', async () => {
        await gallery.opens()
        await gallery.looks('Shy Bo')
        await gallery.looked.getByLabel(child.word('gallery.ghost')).selectOption({ index: 1 })
        await expect(gallery.looked.locator('svg g.ghost')).toBeVisible()
      })
      await test.step('race beside mine', async () => {
        await child.presses('gallery.beside')
        const dialog = page.getByRole('dialog')
        await dialog.getByText('Friendship', { exact: true }).click()
        await dialog.getByRole('button', { name: child.word('gallery.drive') }).click()
        await child.seesLab()
        await expect(page.getByRole('button', { name: 'Bo 2 Shy Bo' })).toBeVisible()
        const projects = new ProjectList(child)
        await projects.opens()
        await projects.seesNames(child.word('gallery.raceName', { title: 'Shy Bo' }), 'Friendship')
      })
    })

    test('the teacher hides, restores, agrees to a photo and closes the gallery', async ({
      child,
      page,
      school: server,
    }) => {
      const school = await anotherClass(server)
      const [fox, owl] = [await joins(school, 'Fuchs'), await joins(school, 'Eule')]
      await sharesOne(owl, 'Shy Bo')
      await sharesOne(owl, 'With a photo', { more: { assets: { ['b'.repeat(64)]: pixel } } })
      const seen = async () => {
        const { status, body } = await fox.asker.ask('GET', '/gallery')
        return status === 200
          ? (body as { items: { title: string }[] }).items.map(({ title }) => title)
          : status
      }
      await expect.poll(seen).toEqual(['Shy Bo'])
      await teaches(page, school)
      // By address: a teacher comes by a bookmark.
      await page.goto(`/teacher?class=${school.id}&view=gallery`)
      await expect(page.locator('article h2')).toHaveText(['Shy Bo'])

      await child.presses('teacher.hideOne', { title: 'Shy Bo' })
      await expect(page.locator('article h2')).toHaveCount(0)
      await expect.poll(seen).toEqual([])
      const show = page.getByLabel(child.word('teacher.galleryShow'))
      await show.selectOption('hidden')
      await child.presses('teacher.restoreOne', { title: 'Shy Bo' })
      await expect.poll(seen).toEqual(['Shy Bo'])

      await show.selectOption('waiting')
      await page.getByRole('button', { name: 'With a photo', exact: true }).click()
      await expect(page.getByRole('img', { name: child.word('teacher.galleryPhoto') })).toBeVisible()
      await page
        .getByRole('dialog')
        .getByRole('button', { name: child.word('teacher.allowOne', { title: 'With a photo' }) })
        .click()
      await expect.poll(seen).toEqual(['With a photo', 'Shy Bo'])

      await page.getByRole('switch', { name: child.word('teacher.galleryOn') }).click()
      await expect.poll(seen).toBe(403)
    })

    test('a child asks a classmate who has finished the card, once the teacher allows it', async ({
      child,
      page,
      browser,
      school: server,
      contextOptions,
      house,
      locale,
    }) => {
      const school = await anotherClass(server)
      const [fox, owl] = [await joins(school, 'Fuchs'), await joins(school, 'Eule')]
      await saves(owl, { starts: [0, 1, 2] })
      await signsIn(page, school, fox)
      await child.opensLab('friendship')
      const pupil = new Pupil(child, school)
      await pupil.opensMenu()
      await expect(child.button('class.askMate')).toHaveCount(0)
      await page.keyboard.press('Escape')

      await school.teacher.ask('PUT', `/classes/${school.id}/gallery`, { asking: true })
      await pupil.opensMenu()
      await child.presses('class.askMate')
      await expect(child.words('class.askMateNobody', { card: child.card('friendship') })).toBeVisible()

      // Who comes while the child is looking appears in the list.
      const context = await browser.newContext({ ...contextOptions, baseURL: house, locale })
      const there = await context.newPage()
      await signsIn(there, school, owl)
      await there.goto('/')
      await page.getByRole('dialog').getByRole('button', { name: 'Eule' }).click()
      const words = child.word('class.mateAsks', { name: 'Fuchs', card: child.card('friendship') })
      await expect(there.getByText(words)).toBeVisible()
      await there.getByRole('button', { name: child.word('class.mateYes') }).click()
      await expect(child.words('class.askedComing', { name: 'Eule' })).toBeVisible()
      await child.presses('parts.ok')
      await expect(child.words('class.askedComing', { name: 'Eule' })).toHaveCount(0)
      await context.close()
    })

    const each = isLong ? 100 : 20
    test(`${5 * each} things on a phone`, async ({ child, page, school: server }) => {
      const school = await anotherClass(server)
      for (const nickname of ['Biber', 'Dachs', 'Eule', 'Hase', 'Igel']) {
        const pupil = await joins(school, nickname)
        for (let at = 0; at < each; at++) await sharesOne(pupil, `${nickname} ${at}`)
      }
      const fox = await joins(school, 'Fuchs')
      await page.setViewportSize({ width: 390, height: 844 })
      await signsIn(page, school, fox)
      const gallery = new GalleryHands(child)
      await gallery.opens()
      for (let count = 24; count < 5 * each; count += 24) {
        await expect(gallery.titles).toHaveCount(count)
        await child.presses('gallery.more')
      }
      await expect(gallery.titles).toHaveCount(5 * each)
      await expect(child.button('gallery.more')).toHaveCount(0)
      const wide = await page.evaluate(() => document.documentElement.scrollWidth)
      expect(wide).toBeLessThanOrEqual(390)
      await gallery.looks('Biber 0')
      await expect
        .poll(() => page.evaluate(() => document.documentElement.scrollWidth))
        .toBeLessThanOrEqual(390)
      await child.presses('parts.close')
      await expect(gallery.looked).toHaveCount(0)
    })
  })
}

const pixel = {
  type: 'image/png',
  base64: 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==',
}
