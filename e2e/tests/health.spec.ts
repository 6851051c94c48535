// Rooms: teacher, server
// By address: a teacher comes by a bookmark of the own page.
import { Asker, classOfTest } from '../class-server.ts'
import { expect, test as base } from '../house.ts'
import { teaches } from '../made-class.ts'
import { languagesOf } from '../words.ts'

type School = Awaited<ReturnType<typeof classOfTest>>

const test = base.extend<{ school: School }>({
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
  school: async ({}, use) => {
    const school = await classOfTest()
    await use(school)
    await school.close()
  },
  baseURL: ({ school }, use) => use(school.url),
  complaints: [/^A request to http:\/\/localhost:\d+\//],
})
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

for (const language of languagesOf(import.meta.filename))
  test.describe(`the health of the server, in ${language}`, () => {
    test.use({ language })

    test('says in sentences what is to do; who runs the server makes the missing backup', async ({
      child,
      page,
      school,
    }) => {
      await teaches(page, school)
      await page.goto('/teacher')
      await child.presses('teacher.person', { name: 'm.weber' })
      await page.getByRole('link', { name: child.word('teacher.health') }).click()
      await expect(page.getByText(child.word('doctor.backup.none'))).toBeVisible()
      await expect(page.getByText(child.word('doctor.https.off'))).toBeVisible()
      for (const about of ['address', 'firewall', 'clients', 'memory', 'disk', 'clock', 'folder', 'version'])
        await expect(page.getByText(child.word(`teacher.about.${about}`), { exact: true })).toBeVisible()
      await child.presses('teacher.backUpNow')
      await expect(page.getByText(child.word('doctor.backup.none'))).toHaveCount(0)
      const day = school.classServer.ports.day(0)
      await expect(page.getByText(child.word('doctor.backup.made', { day, count: 1 }))).toBeVisible()
    })

    test('a teacher who was invited sees it without the folder and the sizes', async ({
      child,
      page,
      school,
    }) => {
      const { token } = (await school.teacher.ask('POST', '/invitations')).body as { token: string }
      const invited = new Asker(school.url)
      await invited.ask('POST', '/teachers', { token, username: 'k.otto', password: 'ein anderer satz' })
      await page.context().addCookies(invited.cookies)
      await page.goto('/teacher/health')
      await expect(page.getByText(child.word('teacher.whoRuns'))).toBeVisible()
      await expect(page.getByText(child.word('doctor.backup.none'))).toBeVisible()
      await expect(page.getByText(child.word('teacher.about.folder'), { exact: true })).toHaveCount(0)
      await expect(child.button('teacher.backUpNow')).toHaveCount(0)
    })
  })
