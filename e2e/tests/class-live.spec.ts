// Rooms: class
import { Child, leftEye, leftWheel } from '../child.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn, type MadeClass } from '../made-class.ts'
import { languagesOf } from '../words.ts'

const test = testInClass()
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

/** What the teacher's page knows of the one pupil. */
async function liveOf({ teacher, id }: MadeClass) {
  const { body } = await teacher.ask('GET', `/classes/${id}/live`)
  const [tile] = (
    body as { tiles: readonly { live: { card: string; running: boolean; trail: object } | null }[] }
  ).tiles
  return tile?.live ?? null
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a lesson, in ${language}`, () => {
    test.use({ language })

    test('a child works while the teacher looks, helps, asks for attention and closes a card', async ({
      child,
      school,
    }) => {
      const { page } = child
      const { teacher, id } = school
      const pupil = await joins(school, 'Fuchs')
      const teaches = async (method: string, path: string, body?: unknown) =>
        expect((await teacher.ask(method, `/classes/${id}${path}`, body)).status).toBeLessThan(300)
      await signsIn(page, school, pupil)
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.8)

      await test.step('the teacher sees what it is at', async () => {
        await child.presses('lab.start')
        await expect.poll(() => liveOf(school)).toMatchObject({ card: 'friendship', running: true })
      })

      await test.step('and the child sees who looks inside', async () => {
        await teaches('POST', `/pupils/${pupil.id}/inside`)
        await expect(child.words('class.looksInBy', { name: 'm.weber' })).toBeVisible()
        await teaches('DELETE', `/pupils/${pupil.id}/inside`)
        await expect(child.words('class.looksInBy', { name: 'm.weber' })).toHaveCount(0)
      })

      await test.step('attention stops Bo, nothing closes it, and the child goes on afterwards', async () => {
        await teaches('PUT', '/attention', { on: true })
        const sheet = page.getByRole('dialog')
        await expect(sheet).toContainText(child.word('class.attentionTitle'))
        await page.keyboard.press('Escape')
        await page.keyboard.press('Escape')
        await expect(sheet).toBeVisible()
        const before = await child.painted.stands()
        await expect.poll(() => liveOf(school)).toMatchObject({ running: false })
        await expect.poll(() => child.painted.stands()).toEqual(before)
        await teaches('PUT', '/attention', { on: false })
        await expect(sheet).toHaveCount(0)
      })

      await test.step('two pages of the browser share what the teacher says', async () => {
        const there = new Child(await page.context().newPage(), language)
        await there.page.addInitScript((here) => sessionStorage.setItem('botgarten.here', here), pupil.id)
        await there.opensLab('fear')
        await teaches('PUT', '/attention', { on: true })
        for (const one of [child, there]) await expect(one.words('class.attentionTitle')).toBeVisible()
        await teaches('PUT', '/attention', { on: false })
        // Left as a child leaves it: the other page has the stream then.
        const closed = there.page.waitForEvent('close')
        await there.page.close({ runBeforeUnload: true })
        await closed
      })

      await test.step('a hint stays until it is put away', async () => {
        await teaches('POST', '/handouts', { to: 'all', kind: 'hint', text: 'Look at the left wheel.' })
        await expect(page.getByText('Look at the left wheel.')).toBeVisible()
        await child.reloads()
        await expect(page.getByText('Look at the left wheel.')).toBeVisible()
        await child.presses('class.putAway')
        await expect(page.getByText('Look at the left wheel.')).toHaveCount(0)
      })

      await test.step('a start program becomes a project of its own', async () => {
        await teaches('POST', '/handouts', { to: [pupil.id], kind: 'program', card: 'friendship' })
        await child.presses('class.openOffer')
        await expect(page).toHaveURL(/\?p=friendship-/)
        await child.seesLab()
        await child.seesWeight(leftEye, leftWheel, 0)
        await expect(child.button('class.openOffer')).toHaveCount(0)
        await child.opensLab('friendship')
        await child.seesWeight(leftEye, leftWheel, 0.8)
      })

      await test.step('a card that is closed leads to those that are open', async () => {
        await teaches('PUT', '/free', { cards: ['fear'], level: 'plain' })
        await expect(page.getByRole('dialog')).toContainText(child.word('class.closedTitle'))
        await page.getByRole('link', { name: child.word('class.toGarden') }).click()
        await child.seesTitle()
        await expect(page.locator('a[href*="/lab/friendship"]:not(.tile)')).toHaveCount(0)
        await child.opensLab('fear')
        await expect(page.getByText(child.word('editor.all'), { exact: true })).toHaveCount(0)
      })

      await test.step('when the class is closed the pictures are asked', async () => {
        await teaches('POST', '/close')
        await expect(child.words('class.whichPictures')).toBeVisible()
      })
    })
  })
}
