// Rooms: class, questionnaires, teacher
import { readFileSync } from 'node:fs'
import { sample } from '@botgarten/numbers/testing'
import type { Page } from '@playwright/test'
import { unzipSync } from 'fflate'
import { opensForm, passes, sends } from '../asked-class.ts'
import { Child } from '../child.ts'
import { Asker, nth } from '../child-questionnaires.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn, teaches } from '../made-class.ts'

const test = testInClass()
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
test.use({ complaints: [/net::ERR_/] })

const minutes = 60_000

/** The child sees that something is asked, and goes there. */
async function goesThere(child: Child) {
  await child.page.goto('/')
  await expect(child.words('class.askedTitle')).toBeVisible()
  await child.page.getByRole('link', { name: child.word('class.askedGo'), exact: true }).click()
  await expect(child.words('form.codeTitle')).toBeVisible()
}

/** What the page sends, and whether it says who sits there. */
const sentBy = (page: Page) =>
  page
    .waitForResponse((response) => response.url().endsWith('/api/class/answers'))
    .then(async (response) => ({
      status: response.status(),
      headers: await response.request().allHeaders(),
      body: response.request().postDataJSON() as object,
    }))

/** Those who answer on a device of their own; of the others only the answers come. */
const onDevices = sample(['Ananas', 'Biber', 'Dachs', 'Eule', 'Falke'], 2)

test('a class of thirty: some answer on their devices, results come when the teacher has closed the form', async ({
  browser,
  school,
  contextOptions,
  house,
}) => {
  test.setTimeout(240_000)
  const options = { ...contextOptions, baseURL: house, locale: 'en-GB' }
  const teacher = new Child(await (await browser.newContext(options)).newPage(), 'en')
  await teaches(teacher.page, school)
  // By address: a teacher comes by a bookmark.
  await teacher.page.goto(`/teacher?class=${school.id}&view=questionnaires`)
  const card = teacher.page
    .getByRole('article')
    .filter({ hasText: new Asker(teacher).form('after').text['en']!.title })
  await card.getByRole('button', { name: teacher.word('form.class.ask'), exact: true }).click()
  await expect(card.getByText(teacher.word('form.class.open'), { exact: true })).toBeVisible()

  const children = await Promise.all(
    onDevices.map(async (nickname, n) => {
      const context = await browser.newContext(options)
      const child = new Child(await context.newPage(), 'en')
      await child.page.clock.install()
      await signsIn(child.page, school, await joins(school, nickname))
      return { child, context, n }
    }),
  )
  for (const { child, n } of children) {
    const asker = new Asker(child)
    await goesThere(child)
    // The second child takes another number than the first one.
    await asker.choosesCode('owl', 200)
    if (n > 0) {
      await expect(child.words('form.codeTaken')).toBeVisible()
      await asker.choosesCode('owl', 200 + n)
    }
    await expect(child.button('form.begin')).toBeEnabled()
    await asker.begins()
    await asker.fillsIn('after', false, nth(n))
    const sending = sentBy(child.page)
    await child.page.clock.fastForward(2 * minutes)
    const { status, headers, body } = await sending
    expect([status, headers['cookie']]).toEqual([204, undefined])
    expect(Object.keys(body).toSorted()).toEqual(['code', 'id', 'key', 'token', 'values'])
    await child.page.goto('/')
    await expect(child.words('class.askedTitle')).toHaveCount(0)
  }

  for (let n = onDevices.length; n < 30; n += 1) expect(await sends(school, 'after', n)).toBe(204)
  await expect(card.getByText(teacher.word('form.answers', { count: 30 }))).toBeVisible()
  await card.getByRole('button', { name: teacher.word('form.close'), exact: true }).click()
  await expect(card.getByText(teacher.word('form.class.closing'), { exact: true })).toBeVisible()
  passes(school, 2)
  await card.getByRole('button', { name: teacher.word('form.results'), exact: true }).click()
  await expect(teacher.page.getByRole('heading', { level: 2 }).first()).toBeVisible()
  const row = teacher.page.getByRole('row').filter({ hasText: 'Teach Bo' }).first()
  await expect(row).toContainText('3.00')
  await expect(row).toContainText('4.57')
  const [file] = await Promise.all([
    teacher.page.waitForEvent('download'),
    teacher.page.getByRole('button', { name: 'CSV' }).click(),
  ])
  const rows = new TextDecoder()
    .decode(unzipSync(readFileSync(await file.path()))['after.csv'])
    .trim()
    .split('\r\n')
  expect(rows).toHaveLength(31)
  expect(rows.join()).not.toMatch(/owl|swan|Bo |20\d\d-/)
  for (const { context } of children) await context.close()
  await teacher.page.context().close()
})

test('a child whose device was exchanged opens the form once more when the teacher allows it', async ({
  browser,
  school,
  contextOptions,
  house,
}) => {
  const options = { ...contextOptions, baseURL: house, locale: 'en-GB' }
  await opensForm(school, 'after')
  const joined = await joins(school, 'Luchs')
  const laptop = async () => {
    const child = new Child(await (await browser.newContext(options)).newPage(), 'en')
    await signsIn(child.page, school, joined)
    await child.page.goto('/')
    await child.page.getByRole('link', { name: child.word('class.askedGo'), exact: true }).click()
    return child
  }
  const broken = await laptop()
  await expect(broken.words('form.codeTitle')).toBeVisible()
  await broken.page.context().close()
  const other = await laptop()
  await expect(other.words('form.class.given')).toBeVisible()

  const teacher = new Child(await (await browser.newContext(options)).newPage(), 'en')
  await teaches(teacher.page, school)
  // By address: a teacher comes by a bookmark.
  await teacher.page.goto(`/teacher?class=${school.id}&view=questionnaires`)
  await teacher.page.getByText(teacher.word('form.class.lost'), { exact: true }).click()
  const names = teacher.page.getByRole('combobox', { name: teacher.word('form.class.lostWho') })
  await names.selectOption('Luchs')
  await teacher.presses('form.class.lostAllow')
  await expect(teacher.words('form.class.lostAllowed')).toBeVisible()

  await other.presses('form.class.again')
  await expect(other.words('form.codeTitle')).toBeVisible()
  await teacher.presses('form.class.lostAllow')
  await expect(teacher.words('form.class.lostBefore')).toBeVisible()
  for (const one of [other, teacher]) await one.page.context().close()
})

test('with the cable pulled a child answers all the same, and its answers come when the cable is back', async ({
  child,
  page,
  school,
  context,
}) => {
  const made = school
  await opensForm(made, 'before')
  await page.clock.install()
  await signsIn(page, made, await joins(made, 'Igel'))
  const asker = new Asker(child)
  await goesThere(child)
  const beforehand = page.locator('.beforehand')
  await expect(beforehand.locator('figure')).not.toHaveCount(0)
  await expect(beforehand.locator('[aria-busy=true]')).toHaveCount(0)
  await context.setOffline(true)
  await child.presses('form.codeForgot')
  await asker.fillsIn('before', false, nth(1))
  await page.clock.fastForward(3 * minutes)
  const waiting = () =>
    page.evaluate(() => JSON.parse(localStorage.getItem('botgarten.answers') ?? '[]') as object[])
  const [kept, ...others] = await waiting()
  expect(others).toEqual([])
  expect(Object.keys(kept!).toSorted()).toEqual(['code', 'id', 'key', 'token', 'values'])
  // The device no longer knows which token is whose.
  await expect.poll(() => page.evaluate(() => localStorage.getItem('botgarten.answerTokens'))).toBeNull()
  expect(JSON.stringify(kept)).not.toMatch(/Igel|20\d\d-/)
  await context.setOffline(false)
  await page.clock.fastForward(3 * minutes)
  await expect.poll(async () => (await waiting()).length).toBe(0)
  await made.teacher.ask('POST', `/classes/${made.id}/questionnaires/before/close`)
})
