// Rooms: teacher, class
import type { Page } from '@playwright/test'
import { Child } from '../child.ts'
import { Asker, firstTeacher, serverWithData } from '../class-server.ts'
import { expect, test as base } from '../house.ts'

type Server = Awaited<ReturnType<typeof serverWithData>>

/** A server of its own: teachers are made and deleted on it. */
const test = base.extend<object, { server: Server }>({
  server: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures
    async ({}, use) => {
      const server = await serverWithData()
      await use(server)
      await server.close()
    },
    { scope: 'worker' },
  ],
  house: [({ server }, use) => use(server.url), { scope: 'worker' }],
})
// An account must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
// A refused password is an answer that a browser reports.
test.use({ complaints: [/status of 40[0139]/] })

const [old, chosen] = ['kastanie im regen', 'kastanie im schnee']

/** A teacher on the pages of this browser. */
class Teacher {
  readonly child: Child
  readonly username: string
  constructor(page: Page, username: string) {
    this.child = new Child(page, 'en', 'mouse')
    this.username = username
  }
  field = (key: string, facts = {}) =>
    this.child.page.getByLabel(this.child.word(`teacher.${key}`, facts), { exact: true })

  async opensSignIn() {
    await this.child.opensHome()
    for (const key of ['parts.about', 'about.teachers'])
      await this.child.page
        .getByRole('link', { name: this.child.word(key), exact: true })
        .first()
        .click()
  }

  async signsIn(password: string) {
    await this.field('username').fill(this.username)
    await this.field('password').fill(password)
    await this.child.presses('teacher.signIn')
  }

  async opensAccount() {
    await this.child.presses('teacher.person', { name: this.username })
    await this.child.page.getByRole('link', { name: this.child.word('teacher.yourAccount') }).click()
    await expect(this.child.page.getByRole('heading', { level: 1 })).toHaveText(
      this.child.word('teacher.yourAccount'),
    )
  }

  async changesPassword(password: string, newPassword: string) {
    const form = this.child.page.locator('form').filter({ has: this.field('account.newPassword') })
    await form.getByLabel(this.child.word('teacher.account.currentPassword'), { exact: true }).fill(password)
    await this.field('account.newPassword').fill(newPassword)
    await this.child.page.keyboard.press('Enter')
  }

  says = (key: string, facts = {}) => expect(this.child.words(`teacher.${key}`, facts)).toBeVisible()
}

/** An account by invitation. @returns the asker of the operator, and of the new teacher */
async function furtherTeacher(server: Server, username: string) {
  const operator = await firstTeacher(server)
  const { token } = (await operator.ask('POST', '/invitations')).body as { token: string }
  const teacher = new Asker(server.url)
  expect((await teacher.ask('POST', '/teachers', { token, username, password: old })).status).toBe(204)
  return { operator, teacher }
}

test('a teacher changes the password, signs in with it elsewhere and deletes the account; the operator deletes another', async ({
  page,
  browser,
  server,
}) => {
  const { operator, teacher } = await furtherTeacher(server, 'k.otto')
  const about = { name: '5b', language: 'en', grade: 5, endsOn: server.classServer.ports.day(120) }
  await teacher.ask('POST', '/classes', about)
  const otto = new Teacher(page, 'k.otto')

  await test.step('wrong and common passwords are shown at their fields, and a good one is changed by keys', async () => {
    await otto.opensSignIn()
    await otto.signsIn(old)
    await otto.opensAccount()
    await otto.changesPassword('kastanie', chosen)
    await otto.says('refused.passwordWrong')
    await otto.changesPassword(old, 'basketball')
    await otto.says('refused.passwordCommon')
    await expect(otto.field('account.newPassword')).toHaveAttribute('aria-invalid', 'true')
    await otto.changesPassword(old, chosen)
    await otto.says('account.changed')
    await expect.poll(async () => (await teacher.ask('GET', '/classes')).status).toBe(401)
  })

  await test.step('a class is in the way of the deletion, and the link leads to it', async () => {
    await otto.says('refused.ownsClasses')
    await page.getByRole('link', { name: otto.child.word('teacher.class', { name: '5b' }) }).click()
    await otto.field('typeName').fill('5b')
    await otto.child.presses('teacher.deleteAll', { name: '5b' })
    await expect(otto.child.button('teacher.makeClass')).toBeVisible()
  })

  await test.step('in another browser the new password signs in, and the account is deleted', async () => {
    const elsewhere = await browser.newContext({ baseURL: server.url })
    const tablet = new Teacher(await elsewhere.newPage(), 'k.otto')
    await tablet.opensSignIn()
    await tablet.signsIn(old)
    await tablet.says('refused.wrongPassword')
    await tablet.signsIn(chosen)
    await tablet.opensAccount()
    const remove = tablet.child.button('teacher.account.deleteOne', { name: 'k.otto' })
    const form = tablet.child.page.locator('form').filter({ has: remove })
    await form.getByLabel(tablet.child.word('teacher.account.currentPassword')).fill(chosen)
    await remove.click()
    await tablet.says('account.deleted')
    await tablet.opensSignIn()
    await tablet.signsIn(chosen)
    await tablet.says('refused.wrongPassword')
    await elsewhere.close()
  })

  await test.step('the operator deletes a teacher who has left, once the username is typed', async () => {
    const { token } = (await operator.ask('POST', '/invitations')).body as { token: string }
    const left = new Asker(server.url)
    await left.ask('POST', '/teachers', { token, username: 'e.klein', password: old })
    await left.ask('POST', '/classes', about)
    const weber = new Teacher(page, 'm.weber')
    await page.context().clearCookies()
    await weber.opensSignIn()
    await weber.signsIn(old)
    await weber.opensAccount()
    await weber.says('refused.onlyOperator')
    await weber.child.presses('teacher.account.deleteOne', { name: 'e.klein' })
    await weber.says('account.deleteWithClasses', { classes: 1, pupils: 0 })
    const remove = page
      .getByRole('dialog')
      .getByRole('button', { name: weber.child.word('teacher.account.deleteShort'), exact: true })
    await expect(remove).toHaveAttribute('aria-disabled', 'true')
    await weber.field('account.typeUsername', { name: 'e.klein' }).fill('e.klein')
    await remove.click()
    await expect(page.getByRole('dialog')).toHaveCount(0)
    await expect(weber.child.button('teacher.account.deleteOne', { name: 'e.klein' })).toHaveCount(0)
    await expect.poll(async () => (await left.ask('GET', '/classes')).status).toBe(401)
  })
})
