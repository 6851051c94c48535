// Rooms: teacher
import { flags } from '../browser.ts'
import { findChromium } from '../chromium.mjs'
import { serverWithData } from '../class-server.ts'
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
  complaints: [/^A request to http:\/\/(localhost|classroom\.test):\d+\//],
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
