// Rooms: teacher
import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { Asker, serverWithData } from '../class-server.ts'
import { expect, test as base } from '../house.ts'
import { projectFile } from '../projects.ts'
import { message } from '../words.ts'

type Server = Awaited<ReturnType<typeof serverWithData>>

/** A server of its own: who makes it theirs has it for good. */
const test = base.extend<object, { server: Server }>({
  server: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
    async ({}, use) => {
      const server = await serverWithData()
      await use(server)
      await server.close()
    },
    { scope: 'worker' },
  ],
  house: [({ server }, use) => use(server.url), { scope: 'worker' }],
})
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

const password = 'kastanie im regen'
/** The cable is pulled for a moment. */
test.use({ complaints: [/ERR_INTERNET_DISCONNECTED/] })

/** What a teacher does on the pages, in English. */
class Teacher {
  readonly page: Page
  constructor(page: Page) {
    this.page = page
  }
  word = (key: string, facts = {}) => message('en', `teacher.${key}`, facts)
  button = (key: string, facts = {}) =>
    this.page.getByRole('button', { name: this.word(key, facts), exact: true })
  link = (key: string) => this.page.getByRole('link', { name: this.word(key), exact: true })
  field = (key: string) => this.page.getByLabel(this.word(key), { exact: true })
  says = (key: string, facts = {}) => this.page.getByText(this.word(key, facts), { exact: true })
  tile = (name: string) =>
    this.page.getByRole('listitem').filter({ hasText: name }).getByRole('button').first()
}

const here = {
  ...{ card: 'friendship', project: 'friendship', checks: ['passed', 'failed', 'open'], failed: 2 },
  ...{ running: true, idle: 0, size: [600, 400], pose: { x: 360, y: 210, heading: 200 } },
  trail: [440, 250, 420, 240, 400, 230, 380, 220],
}

async function joins(server: Server, words: readonly string[], nickname: string) {
  const asker = new Asker(server.url)
  const joined = await asker.ask('POST', '/join', { code: words.join('-'), nickname })
  expect(joined.status).toBe(201)
  const file = JSON.parse(projectFile('friendship', 'solution')) as object
  const project = { ...file, progress: { starts: [0], hints: 0 } }
  const saved = await asker.ask('PUT', '/projects/friendship?base=0&save=save-0001', project)
  expect(saved.status).toBe(200)
  return asker
}

test('a teacher starts a server, leads a lesson and deletes the class', async ({ page, server }) => {
  const teacher = new Teacher(page)

  await test.step('the one-time link makes the account by keys alone, then class, Wi-Fi, rehearsal and backup', async () => {
    // By address: the link that the server prints.
    await page.goto(`/teacher/start#${await server.classServer.firstTeacher()}`)
    await teacher.field('username').fill('m.weber')
    await page.keyboard.press('Tab')
    await page.keyboard.type(password)
    await page.keyboard.press('Enter')
    await teacher.field('className').fill('5b')
    await page.keyboard.press('Enter')
    await teacher.field('wifiName').fill('Aula')
    await teacher.field('wifiPassword').fill('sonnenblume')
    await page.keyboard.press('Enter')
    await teacher.button('rehearseNow').click()
    await expect(page.getByRole('progressbar')).toBeVisible()
    await teacher.button('stop').click()
    await expect(teacher.says('rehearsalStopped')).toBeVisible()
    await page.reload()
    // Nothing but the class and its Wi-Fi is remembered: it may be rehearsed again, or not.
    await teacher.button('rehearseSkip').click()
    await teacher.button('backUpNow').click()
    await expect(page.getByText(/^(?:[a-z]+-){9}[a-z]+$/)).toBeVisible()
    await teacher.button('phrase.written').click()
    await expect(teacher.link('toClass')).toBeVisible()
  })

  const words = await test.step('the projector page opens the class and shows its code', async () => {
    await teacher.link('toProjector').click()
    await teacher.button('startJoining').click()
    await expect(page.getByRole('img', { name: teacher.word('qr') })).toBeVisible()
    await expect(page.getByRole('img', { name: teacher.word('wifiQr') })).toBeVisible()
    await expect(page.getByText('sonnenblume', { exact: true })).toBeVisible()
    return page.locator('.code > span').allInnerTexts()
  })

  await test.step('the Wi-Fi on the wall is changed, and taken off it', async () => {
    await teacher.button('wifi').click()
    await teacher.field('wifiPassword').fill('short')
    await expect(teacher.button('save')).toHaveAttribute('aria-disabled', 'true')
    await teacher.field('wifiPassword').fill('')
    await page.keyboard.press('Enter')
    await expect(teacher.says('wifiOpen')).toBeVisible()
    await page.reload()
    await expect(teacher.says('wifiOpen')).toBeVisible()
    await teacher.button('wifi').click()
    await teacher.button('wifiRemove').click()
    await expect(teacher.says('wifiOpen')).toHaveCount(0)
    await expect(page.getByRole('img', { name: teacher.word('wifiQr') })).toHaveCount(0)
  })

  const child = await joins(server, words, 'Fuchs')
  await test.step('who joins is counted on the wall and appears live', async () => {
    await expect(page.locator('.joined b')).toHaveText('1')
    await joins(server, words, 'Ananas')
    await expect(page.locator('.joined b')).toHaveText('2')
    await teacher.link('toClass').click()
    await expect(teacher.tile('Fuchs')).toBeVisible()
    await child.ask('PUT', '/me/here', here)
    await child.ask('PUT', '/me/hand', { up: true })
    await expect(page.getByRole('listitem').first()).toContainText('Fuchs')
    await expect(teacher.tile('Fuchs')).toContainText(/Friendship/)
  })

  type Me = { attention: number | null; inside: unknown; handouts: { kind: string; hint: number | null }[] }
  const me = async () => (await child.ask('GET', '/me')).body as Me

  await test.step('a hint, a look inside and attention reach the child', async () => {
    await teacher.tile('Fuchs').focus()
    await page.keyboard.press('Enter')
    await page.getByRole('button', { name: '2', exact: true }).click()
    await teacher.button('sendHint', { number: 2, name: 'Fuchs' }).click()
    await expect(teacher.says('hintSent', { name: 'Fuchs' })).toBeVisible()
    await expect.poll(async () => (await me()).handouts).toMatchObject([{ kind: 'hint', hint: 2 }])
    await teacher.button('look').click()
    await expect(page.getByRole('dialog').getByRole('img')).toHaveCount(2)
    await expect.poll(async () => (await me()).inside).toEqual({ by: 'm.weber' })
    await page.keyboard.press('Escape')
    await expect.poll(async () => (await me()).inside).toBeNull()
    await teacher.button('handDown').click()
    await expect(teacher.button('handDown')).toHaveCount(0)
    await teacher.button('attention').click()
    await expect(teacher.button('goOn')).toBeVisible()
    await expect.poll(async () => (await me()).attention).toBeGreaterThan(0)
    await teacher.button('goOn').click()
    await expect(teacher.button('attention')).toBeVisible()
    await expect.poll(async () => (await me()).attention).toBeNull()
  })

  await test.step('a stream that breaks is said in words, and comes back by itself', async () => {
    await page.context().setOffline(true)
    await expect(teacher.says('streamBroken')).toBeVisible()
    await page.context().setOffline(false)
    await expect(teacher.says('streamBroken')).toHaveCount(0)
  })

  await test.step('the matrix shows who has done what, and is saved as CSV', async () => {
    await teacher.button('cards').click()
    await page.reload()
    const row = page.getByRole('row', { name: /Fuchs/ })
    await row.getByRole('button').focus()
    await page.keyboard.press('Enter')
    await expect(
      row.getByRole('img', { name: teacher.word('workingOf', { passed: 1, of: 3 }) }),
    ).toBeVisible()
    await teacher.button('lookInto', { name: 'Fuchs' }).click()
    await expect(page.getByRole('dialog').getByRole('img')).toHaveCount(2)
    await expect.poll(async () => (await me()).inside).toEqual({ by: 'm.weber' })
    await page.keyboard.press('Escape')
    await expect.poll(async () => (await me()).inside).toBeNull()
    const [download] = await Promise.all([page.waitForEvent('download'), teacher.link('csv').click()])
    expect(await readFile(await download.path(), 'utf8')).toMatch(/\r\nFuchs,.*1\/3/)
  })

  await test.step('pupils are renamed and get new pictures', async () => {
    await teacher.button('settings').click()
    await teacher.button('more', { name: 'Ananas' }).click()
    await teacher.button('rename').click()
    await teacher.field('nickname').fill('Kiwi')
    await page.keyboard.press('Enter')
    await teacher.button('more', { name: 'Kiwi' }).click()
    await teacher.button('newPictures').click()
    await page
      .getByRole('dialog')
      .getByRole('button', { name: teacher.word('newPictures') })
      .click()
    await expect(page.getByRole('dialog').getByRole('listitem')).toHaveCount(3)
    await page.keyboard.press('Escape')
  })

  await test.step('in German too, the class is deleted once its name is typed', async () => {
    await page.getByRole('button', { name: 'Deutsch' }).click()
    const german = (key: string, facts = {}) => message('de', `teacher.${key}`, facts)
    await page.getByRole('button', { name: german('data'), exact: true }).click()
    const remove = page.getByRole('button', { name: german('deleteAll', { name: '5b' }) })
    await expect(remove).toHaveAttribute('aria-disabled', 'true')
    const untilDay = german('backupsHold', { day: '…' }).split('…')[0]!
    for (const copies of [untilDay, german('copiesElsewhere')])
      await expect(page.getByText(copies)).toBeVisible()
    await page.getByLabel(german('typeName')).fill('5b')
    await remove.click()
    await expect(page.getByRole('heading', { name: german('newClass') })).toBeVisible()
    await expect
      .poll(() => child.ask('GET', '/me'))
      .toMatchObject({ status: 410, body: { error: 'classEnded' } })
  })
})
