// Rooms: class, teacher
// By address: a teacher comes by a bookmark of the own page.
import { classOfTest, setClock } from '../class-server.ts'
import { Child, leftEye, leftWheel } from '../child.ts'
import { expect, test as base } from '../house.ts'
import { joins, signsIn, teaches } from '../made-class.ts'
import { languagesOf } from '../words.ts'

type School = Awaited<ReturnType<typeof classOfTest>>

const test = base.extend<{ school: School }>({
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures
  school: async ({}, use) => {
    const school = await classOfTest()
    await use(school)
    await school.close()
  },
  baseURL: ({ school }, use) => use(school.url),
  complaints: [/^A request to http:\/\/(?:localhost|127\.0\.0\.1):\d+\/|410 \(Gone\)|423 \(Locked\)/],
})
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

for (const language of languagesOf(import.meta.filename))
  test.describe(`a clock that is doubted, in ${language}`, () => {
    test.use({ language })

    test('hides a class that has ended until the operator calls the clock wrong, or deletes it if it is right', async ({
      browser,
      child,
      contextOptions,
      page,
      school,
    }) => {
      const jump = setClock(school)
      const pupil = await joins(school, 'Fuchs')
      await signsIn(page, school, pupil)
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.8)
      const project = async () => (await pupil.asker.ask('GET', '/projects')).body
      await expect.poll(project).toMatchObject({ projects: [{ id: 'project-friendship' }] })

      const locale = language === 'de' ? 'de-DE' : 'en-GB'
      const options = { ...contextOptions, baseURL: school.url, locale }
      const teacher = new Child(await (await browser.newContext(options)).newPage(), language)
      await teaches(teacher.page, school)
      const toHealth = async () => {
        await teacher.page.goto('/teacher')
        await teacher.page.getByRole('link', { name: /5b/ }).click()
      }
      const hidden = child.words('class.hidden')

      await test.step('the child sees where its class is, and that its work is safe', async () => {
        jump(300)
        await expect(hidden).toBeVisible()
        await expect(child.words('class.hiddenText')).toBeVisible()
        await child.presses('class.tryAgain')
        await expect(hidden).toBeVisible()
      })

      await test.step('the clock is wrong: the class is shown again, with everything in it', async () => {
        await toHealth()
        await expect(teacher.words('teacher.clockDoubt.ended', { ended: 1 })).toBeVisible()
        await teacher.presses('teacher.clockDoubt.wrongShow')
        await expect(teacher.words('teacher.clockDoubt.denied')).toBeVisible()
        await child.presses('class.tryAgain')
        await expect(hidden).toHaveCount(0)
        await expect.poll(project).toMatchObject({ projects: [{ id: 'project-friendship' }] })
      })

      await test.step('the clock is right: the class is deleted', async () => {
        jump(330)
        await expect(hidden).toBeVisible()
        await toHealth()
        await teacher.presses('teacher.clockDoubt.rightDelete')
        await expect(teacher.words('teacher.clockDoubt.title')).toHaveCount(0)
        await child.presses('class.tryAgain')
        await expect(child.words('class.ended')).toBeVisible()
      })
      await teacher.page.context().close()
    })
  })
