import { Asker, classOfTest } from '../../class-server.ts'
import { expect, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en', complaints: [/^A request to http:\/\/localhost:\d+\/|status of 4\d\d/] })

/** Numbers of the machine, the phrase, ids and secrets. */
const hides =
  /\d+ fine · \d+ to do|\d[\d.,]* (?:MB|GB)|(?:[a-z]+-){9}[a-z]+|(?<=class=)[\w-]+|(?<=start#)[\w-]+|\d{4}-\d\d-\d\d|botgarten-data-\w+|(?<=paragraph: )[a-z ]+$|(?<=Class \w+ )[a-z]+(?: [a-z]+)+(?= ends)/g

const [old, chosen] = ['kastanie im regen', 'kastanie im schnee']

/** A server with the operator m.weber and the invited k.otto, who has a class, too. */
async function opensServer() {
  const server = await classOfTest()
  const invited = async (username: string) => {
    const { token } = (await server.teacher.ask('POST', '/invitations')).body as { token: string }
    const teacher = new Asker(server.url)
    await teacher.ask('POST', '/teachers', { token, username, password: old })
    return teacher
  }
  const otto = await invited('k.otto')
  const { day } = server.classServer.ports
  const about = { name: '7c', language: 'en', grade: 7, endsOn: day(120) }
  await otto.ask('POST', '/classes', about)
  await server.teacher.ask('POST', '/classes', { ...about, name: '8a', endsOn: day(10) })
  return { server, otto, invited }
}

test('the account of a teacher, step by step', { tag: '@teacher' }, async ({ child, page }) => {
  const { server, otto, invited } = await opensServer()
  await invited('e.klein')
  const dialog = page.getByRole('dialog')
  const field = (key: string, facts = {}) =>
    page.getByLabel(child.word(`teacher.${key}`, facts), { exact: true })
  const current = field('account.currentPassword')
  const goes = async (name: string, key: string) => {
    await child.presses('teacher.person', { name })
    await page
      .getByRole('link', { name: child.word(`teacher.${key}`), exact: true })
      .last()
      .click()
  }
  const signsIn = async (name: string, password: string) => {
    await field('username').fill(name)
    await field('password').fill(password)
    await child.presses('teacher.signIn')
  }
  await goesThrough(
    child,
    'teacher-account',
    {
      'signed out': async () => {
        await page.goto(`${server.url}/teacher`)
        await child.seesTitle()
      },
      'a wrong password': () => signsIn('m.weber', chosen),
      'the classes': () => signsIn('m.weber', old),
      'a new class': () => child.presses('teacher.newClass'),
      'no new class': () => child.presses('teacher.cancel'),
      'a class is made': async () => {
        await child.presses('teacher.newClass')
        await field('className').fill('9d')
        await child.presses('teacher.makeClass')
      },
      'the classes again': async () => {
        await goes('m.weber', 'myClasses')
        await expect(page.getByRole('link', { name: 'Class 9d' })).toBeVisible()
        await goes('m.weber', 'myClasses')
      },
      'a teacher is invited': async () => {
        await child.presses('teacher.person', { name: 'm.weber' })
        await child.presses('teacher.invite')
      },
      'the link is there': () => child.presses('parts.close'),
      'the account': async () => {
        await goes('m.weber', 'yourAccount')
        await expect(child.button('teacher.account.deleteOne', { name: 'e.klein' })).toBeVisible()
        await goes('m.weber', 'yourAccount')
      },
      'the current password is wrong': async () => {
        await current.fill('falsch')
        await field('account.newPassword').fill('basketball')
        await child.presses('teacher.account.change')
      },
      'the new password is too common': async () => {
        await current.fill(old)
        await child.presses('teacher.account.change')
      },
      'the password is changed': async () => {
        await field('account.newPassword').fill(chosen)
        await field('account.newPassword').press('Enter')
        await expect(child.words('teacher.account.changed')).toBeVisible()
      },
      'an account with a class is to go': () =>
        child.presses('teacher.account.deleteOne', { name: 'k.otto' }),
      'it stays': () => child.presses('teacher.cancel'),
      'an account without a class is to go': () =>
        child.presses('teacher.account.deleteOne', { name: 'e.klein' }),
      'its name is typed': () => field('account.typeUsername', { name: 'e.klein' }).fill('e.klein'),
      'it has gone already': async () => {
        await page.route('**/api/class/teachers/*', (route) =>
          route.fulfill({ status: 404, json: { error: 'noSuchTeacher' } }),
        )
        await dialog.getByRole('button', { name: child.word('teacher.account.deleteShort') }).click()
        await expect(page.getByText(child.word('teacher.refused.noSuchTeacher'))).toBeVisible()
        await page.unroute('**/api/class/teachers/*')
      },
      'it is deleted': async () => {
        await field('account.typeUsername', { name: 'e.klein' }).press('Enter')
        await expect(dialog).toHaveCount(0)
      },
      'signed out everywhere': async () => {
        await child.presses('teacher.person', { name: 'm.weber' })
        await child.presses('teacher.signOutEverywhere')
      },
      'an account without the others': () => signsIn('k.otto', old),
      'it can be deleted': async () => {
        const { classes } = (await otto.ask('GET', '/classes')).body as { classes: readonly { id: string }[] }
        await otto.ask('DELETE', `/classes/${classes[0]!.id}`, { name: '7c' })
        await page.reload()
        await expect(page.getByText(child.word('teacher.account.deleteText'))).toBeVisible()
      },
      'the password for it is wrong': async () => {
        await current.last().fill(chosen)
        await child.presses('teacher.account.deleteOne', { name: 'k.otto' })
      },
      'the own account is deleted': async () => {
        await current.last().fill(old)
        await child.presses('teacher.account.deleteOne', { name: 'k.otto' })
      },
    },
    { hides },
  )
  await page
    .getByRole('link', { name: child.word('parts.home') })
    .last()
    .click()
  await expect(page.getByRole('heading', { level: 1 })).toContainText(child.word('home.title'))
  await server.close()
})
