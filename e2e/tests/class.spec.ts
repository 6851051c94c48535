// Rooms: class
import { axeFindings } from '../axe.ts'
import { Pupil } from '../child-class.ts'
import { ProjectList } from '../child-projects.ts'
import { Child, leftEye, leftWheel } from '../child.ts'
import { classOfTest } from '../class-server.ts'
import { expect, test as base } from '../house.ts'
import { languagesOf } from '../words.ts'

type School = Awaited<ReturnType<typeof classOfTest>>

const test = base.extend<object, { school: School }>({
  school: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
    async ({}, use) => {
      const school = await classOfTest()
      await use(school)
      await school.close()
    },
    { scope: 'worker' },
  ],
  house: [({ school }, use) => use(school.url), { scope: 'worker' }],
})

const isAccessible = async (child: Child) => expect(await axeFindings(child.page)).toEqual([])

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a class, in ${language}`, () => {
    test.use({ language })

    test('a child joins, works, leaves the device to another one and finds its work on a second one', async ({
      child,
      browser,
      school,
      contextOptions,
      locale,
      house,
    }) => {
      const first = new Pupil(child, school)
      const pictures = await test.step('the code of the wall leads in', async () => {
        await first.opens()
        await expect(first.nickname).toBeFocused()
        await isAccessible(child)
        return first.joins('Fuchs')
      })
      await isAccessible(child)
      await first.remembers()

      await test.step('what it changes goes to the class', async () => {
        await child.chooses('friendship')
        await child.typesWeight(leftEye, leftWheel, 0.8)
        await expect(first.chip('chipClass')).toBeVisible()
        await first.leaves()
      })

      await test.step('another child on the same device sees nothing of it', async () => {
        const other = new Pupil(child, school)
        await other.opens()
        await other.joins('Kiwi')
        await other.remembers()
        await child.chooses('friendship')
        await child.seesWeight(leftEye, leftWheel, 0)
        const projects = new ProjectList(child)
        await projects.opens()
        await projects.seesNames()
      })

      await test.step('the first one comes back by its pictures on a second device', async () => {
        const context = await browser.newContext({ ...contextOptions, baseURL: house, locale })
        const there = new Child(await context.newPage(), language)
        const back = new Pupil(there, school)
        await back.opensByLink()
        await back.returns('Fuchs')
        await back.taps(...pictures)
        await expect(there.words('class.workIsHere')).toBeVisible()
        await isAccessible(there)
        await there.presses('class.toGarden')
        await there.chooses('friendship')
        await there.seesWeight(leftEye, leftWheel, 0.8)
        await context.close()
      })
    })
  })
}
