import { serverWithData } from '../class-server.ts'
import type { Child } from '../child.ts'
import { joins, saves, teaches } from '../made-class.ts'
import { expect, follows, link, test } from './gate.ts'

test.use({ language: 'de', complaints: [/^A request to http:\/\/localhost:\d+\//] })

const password = 'kastanie im regen'
const field = (child: Child, key: string) =>
  child.page.getByLabel(child.word(`teacher.${key}`), { exact: true })

/** The status that a pupil's page reports while it works. */
const atWork = {
  ...{ card: 'friendship', project: 'project-friendship', checks: ['passed', 'failed', 'open'], failed: 2 },
  ...{ running: true, idle: 0, size: [600, 400], pose: { x: 360, y: 210, heading: 200 } },
  trail: [440, 250, 420, 240, 400, 230, 380, 220],
}

test(
  'a teacher signs in, sees a pupil at work, sends a hint, asks for attention and reads who has done what',
  {
    tag: ['@teacher', '@/teacher'],
  },
  async ({ child, page, school }) => {
    const fox = await joins(school, 'Fuchs')
    await saves(fox, { starts: [0] })
    await fox.asker.ask('PUT', '/me/here', atWork)
    await fox.asker.ask('PUT', '/me/hand', { up: true })
    await follows(child, 'parts.about')
    await link(child, 'about.teachers').click()
    await field(child, 'username').fill('m.weber')
    await field(child, 'password').fill(password)
    await child.presses('teacher.signIn')
    await page.locator(`a[href*="class=${school.id}"]`).first().click()

    const tile = page.getByRole('listitem').filter({ hasText: 'Fuchs' }).getByRole('button').first()
    await expect(tile).toContainText(child.card('friendship'))
    await tile.click()
    await page.getByRole('button', { name: '2', exact: true }).click()
    await child.presses('teacher.sendHint', { number: 2, name: 'Fuchs' })
    await expect(child.words('teacher.hintSent', { name: 'Fuchs' })).toBeVisible()
    const me = async () => (await fox.asker.ask('GET', '/me')).body
    await expect.poll(me).toMatchObject({ handouts: [{ kind: 'hint', hint: 2 }], attention: null })
    await child.presses('teacher.look')
    await expect(page.getByRole('dialog').getByRole('img')).toHaveCount(2)
    await expect.poll(me).toMatchObject({ inside: { by: 'm.weber' } })
    await child.types('Escape')
    await child.presses('teacher.attention')
    await expect(child.button('teacher.goOn')).toBeVisible()
    await expect.poll(me).not.toMatchObject({ attention: null })
    await child.presses('teacher.goOn')

    await child.presses('teacher.cards')
    const row = page.getByRole('row', { name: /Fuchs/ })
    await row.getByRole('button').click()
    await expect(
      row.getByRole('img', { name: child.word('teacher.workingOf', { passed: 1, of: 3 }) }),
    ).toBeVisible()
    await child.presses('teacher.settings')
    await child.presses('teacher.more', { name: 'Fuchs' })
    await child.presses('teacher.rename')
    await field(child, 'nickname').fill('Luchs')
    await page.keyboard.press('Enter')
    await expect(child.button('teacher.more', { name: 'Luchs' })).toBeVisible()
  },
)

test(
  'the projector shows the code that pupils type and counts who has joined',
  {
    tag: ['@teacher', '@/teacher/projector'],
  },
  async ({ child, page, school }) => {
    await joins(school, 'Fuchs')
    await teaches(page, school)
    await page.goto(`/teacher/projector?class=${school.id}`)
    await expect(page.locator('.code > span')).toHaveText(school.code.split(' '))
    await expect(page.locator('.joined b')).toHaveText('1')
    await expect(page.getByRole('img', { name: child.word('teacher.qr') })).toBeVisible()
    await joins(school, 'Eule')
    await expect(page.locator('.joined b')).toHaveText('2')
  },
)

test(
  'a substitute gets one class by a link, and sees who is there',
  {
    tag: ['@teacher', '@/teacher/substitute'],
  },
  async ({ child, page, school }) => {
    const fox = await joins(school, 'Fuchs')
    await fox.asker.ask('PUT', '/me/here', atWork)
    await teaches(page, school)
    await page.goto(`/teacher?class=${school.id}&view=class`)
    await child.presses('teacher.substituteMake')
    const address = page.getByRole('textbox', { name: child.word('teacher.substituteLink') })
    const lent = new URL(await address.inputValue())
    await page.context().clearCookies()
    await page.goto(`${lent.pathname}${lent.hash}`)
    await expect(page.getByRole('listitem').filter({ hasText: 'Fuchs' })).toBeVisible()
  },
)

test(
  'the first teacher makes an account and a class, and sees that the server is well and who has an account',
  {
    tag: ['@teacher', '@/teacher/start', '@/teacher/health', '@/teacher/account'],
  },
  async ({ child, page }) => {
    const server = await serverWithData()
    await page.goto(`${server.url}/teacher/start#${await server.classServer.firstTeacher()}`)
    await field(child, 'username').fill('k.otto')
    await field(child, 'password').fill(password)
    await child.presses('teacher.makeAccount')
    await field(child, 'className').fill('7c')
    await child.presses('teacher.makeClass')
    await child.presses('teacher.wifiSkip')
    await child.presses('teacher.rehearseSkip')
    await child.presses('teacher.backUpNow')
    await child.presses('teacher.phrase.written')
    await link(child, 'teacher.toClass').click()
    await expect(page.getByRole('navigation', { name: child.word('teacher.views') })).toBeVisible()
    await child.presses('teacher.person', { name: 'k.otto' })
    await page.getByRole('link', { name: child.word('teacher.health') }).click()
    const day = server.classServer.ports.day(0)
    await expect(page.getByText(child.word('doctor.backup.made', { day, count: 1 }))).toBeVisible()
    await expect(page.getByText(child.word('teacher.about.folder'), { exact: true })).toBeVisible()
    await child.presses('teacher.person', { name: 'k.otto' })
    await page.getByRole('link', { name: child.word('teacher.yourAccount') }).click()
    await expect(page.getByText(child.word('teacher.account.has', { classes: 1, pupils: 0 }))).toBeVisible()
    await expect(child.words('teacher.refused.onlyOperator')).toBeVisible()
    await server.close()
  },
)
