// Rooms: teacher, server
// By address: a teacher comes by a bookmark of the own page.
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { restore } from '../../packages/classroom/index.ts'
import { openClassServer, startServer } from '../../packages/server/index.ts'
import { Asker, classOfTest, pupilOf } from '../class-server.ts'
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
  complaints: [/^A request to http:\/\/(?:localhost|127\.0\.0\.1):\d+\/|403 \(Forbidden\)/],
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

    test('a backup is downloaded, and opened on another machine with the words that the page shows', async ({
      child,
      page,
      school,
    }) => {
      await pupilOf(school.url, school.code, 'Fuchs')
      await teaches(page, school)
      await page.goto('/teacher/health')
      await child.presses('teacher.backUpNow')
      await child.presses('teacher.phrase.show')
      const words = page.getByText(/^(?:[a-z]+-){9}[a-z]+$/)
      const phrase = await words.innerText()
      await child.presses('parts.close')
      await expect(words).toHaveCount(0)

      // Another person at the open page needs the password.
      await child.presses('teacher.phrase.show')
      const password = page.getByLabel(child.word('teacher.password'), { exact: true })
      await password.fill('kastanie im schnee')
      await child.presses('teacher.phrase.open')
      await expect(page.getByText(child.word('teacher.refused.passwordWrong'))).toBeVisible()
      await password.fill('kastanie im regen')
      await page.keyboard.press('Enter')
      await expect(words).toHaveText(phrase)
      await child.presses('parts.close')

      const downloads = page.waitForEvent('download')
      await page.getByRole('link', { name: child.word('teacher.backUpDownload') }).click()
      const download = await downloads
      expect(download.suggestedFilename()).toBe(`botgarten-000001-${school.classServer.ports.day(0)}.age`)
      const folder = mkdtempSync(join(tmpdir(), 'botgarten-elsewhere-'))
      const [file, data] = [join(folder, 'download.age'), join(folder, 'data')]
      await download.saveAs(file)
      expect(await restore(data, file, { day: school.classServer.ports.day(0), phrase })).toMatchObject({
        ...{ kind: 'restored', before: null },
      })
      const classServer = await openClassServer({ data })
      const elsewhere = await startServer({ port: 0, host: '127.0.0.1', classServer })
      // A browser sends cookies to every port of a machine.
      await page.context().clearCookies()
      await page.goto(`${elsewhere.url}/teacher`)
      await page.getByLabel(child.word('teacher.username'), { exact: true }).fill('m.weber')
      await password.fill('kastanie im regen')
      await page.keyboard.press('Enter')
      await expect(page.getByRole('link', { name: /5b/ })).toBeVisible()
      await elsewhere.close()
      rmSync(folder, { recursive: true })
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
