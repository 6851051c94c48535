// Rooms: teacher, parts
// By address: every page as its link opens it.
import { globSync } from 'node:fs'
import { flags } from '../browser.ts'
import { findChromium } from '../chromium.mjs'
import { axeFindings } from '../axe.ts'
import { serverWithData } from '../class-server.ts'
import { inHouse } from '../../scripts/prepare/house.mjs'
import { expect, test as base } from '../house.ts'
import { message } from '../words.ts'

/** A name that leads to this machine: for the browser it is a classroom's server, plain http. */
const classroom = 'classroom.test'

const test = base.extend<{ room: Awaited<ReturnType<typeof serverWithData>> }>({
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
  room: async ({}, use) => {
    const room = await serverWithData()
    await use(room)
    await room.close()
  },
})
test.use({
  // 401 and signIn: a request of the page at the moment when its cookies are cleared.
  complaints: [
    /40[134] \((Unauthorized|Forbidden|Not Found)\)|^signIn$|^A request to http:\/\/(localhost|classroom\.test):\d+\//,
  ],
  launchOptions: {
    executablePath: findChromium() ?? undefined,
    args: [...flags, `--host-resolver-rules=MAP ${classroom} 127.0.0.1`],
  },
})

test('over plain http teachers are told to use a password of its own, where they choose it and where they sign in', async ({
  page,
  room,
}) => {
  const warning = page.getByText(message('en', 'teacher.plainHttp'))
  const password = page.getByLabel(message('en', 'teacher.password'), { exact: true })
  const elsewhere = `http://${classroom}:${room.port}`
  const token = await room.classServer.firstTeacher()

  await page.goto(`${room.url}/teacher/start#${token}`)
  await expect(password).toBeVisible()
  await expect(warning).toHaveCount(0)
  await page.goto(`${elsewhere}/teacher/start#${token}`)
  await expect(warning).toBeVisible()
  await expect(password).toHaveAccessibleDescription(new RegExp(message('en', 'teacher.plainHttp')))
  await page.getByLabel(message('en', 'teacher.username'), { exact: true }).fill('m.weber')
  await password.fill('kastanie im regen')
  await page.keyboard.press('Enter')
  await expect(page.getByLabel(message('en', 'teacher.className'), { exact: true })).toBeVisible()

  await page.context().clearCookies()
  await page.goto(`${elsewhere}/teacher`)
  await expect(warning).toBeVisible()
  await page.goto(`${room.url}/teacher`)
  await expect(password).toBeVisible()
  await expect(warning).toHaveCount(0)
})

/** What stands in an address where a page has a parameter. */
const members: { readonly [parameter: string]: string } = {
  '[card]': 'friendship',
  '[kind]': 'sheet',
  '[id]': 'q-program',
}
/** The wall has no room for it: the teacher's other pages say it. */
const onTheWall = 'teacher/projector'

const pages = globSync('**/+page.svelte', { cwd: inHouse('apps', 'web', 'src', 'routes') })
  .map((file) => file.replace(/\/?\+page\.svelte$/, ''))
  .filter((page) => page !== onTheWall)
  .map((page) => `/${page.replace(/\[\w+\]/g, (parameter) => members[parameter] ?? parameter)}`)

test('over plain http every page says what is missing and leads to how that is changed; none does on the machine itself', async ({
  page,
  room,
  child,
}) => {
  test.setTimeout(180_000)
  await page.addInitScript(() => sessionStorage.setItem('botgarten.stays', 'yes'))
  const says = page.getByRole('button', { name: child.word('offline.plain') })
  expect(pages.length).toBeGreaterThan(15)
  for (const path of [...pages, '/nowhere']) {
    await page.goto(`http://${classroom}:${room.port}${path}`)
    await expect(says, path).toBeVisible()
  }
  await says.click()
  const sheet = page.getByRole('dialog')
  for (const key of ['start', 'keep', 'copy', 'read'])
    await expect(sheet).toContainText(child.word(`plain.${key}`))
  expect(await axeFindings(page)).toEqual([])
  await sheet.getByRole('link', { name: child.word('plain.how') }).click()
  await expect(page).toHaveURL(/\/trust$/)

  await page.goto(`${room.url}/about`)
  await child.seesTitle()
  await expect(says).toHaveCount(0)
})
