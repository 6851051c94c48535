// Rooms: class
import { Pupil } from '../child-class.ts'
import { ProjectList } from '../child-projects.ts'
import { Child, leftEye, leftWheel } from '../child.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { anotherClass, joins, saves, signsIn } from '../made-class.ts'
import { languagesOf } from '../words.ts'

const test = testInClass()
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
// What the class answers to two devices, and when it has ended: a browser complains of it.
test.use({ complaints: [/409 \(Conflict\)|410 \(Gone\)/] })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a class, in ${language}`, () => {
    test.use({ language })

    test('a child joins, works, leaves the device to another one and finds its work on a second one', async ({
      child,
      browser,
      school: server,
      contextOptions,
      locale,
      house,
    }) => {
      const school = await anotherClass(server)
      const first = new Pupil(child, school)
      const pictures = await test.step('the code of the wall leads in', async () => {
        await first.opens()
        await expect(first.nickname).toBeFocused()
        return first.joins('Fuchs')
      })
      await first.remembers()

      await test.step('what it changes goes to the class', async () => {
        await child.opensLab('friendship')
        await child.typesWeight(leftEye, leftWheel, 0.8)
        await expect(first.chip('chipClass')).toBeVisible()
        await first.leaves()
      })

      await test.step('another child on the same device sees nothing of it', async () => {
        const other = new Pupil(child, school)
        await other.opens()
        await other.joins('Kiwi')
        await other.remembers()
        await child.opensLab('friendship')
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
        await back.taps(...pictures.toReversed())
        await back.isRefused()
        await back.taps(...pictures)
        await expect(there.words('class.workIsHere')).toBeVisible()
        await there.presses('class.toGarden')
        await there.opensLab('friendship')
        await there.seesWeight(leftEye, leftWheel, 0.8)
        await context.close()
      })
    })

    test('a child is asked who it is, takes an earlier version, keeps both devices, throws away, and the class ends', async ({
      child,
      page,
      school: server,
    }) => {
      const school = await anotherClass(server)
      const made = await joins(school, 'Otter')
      await saves(made, { program: 'start' })
      await saves(made, { base: 1 })
      await signsIn(page, school, made, 'asks')
      const pupil = new Pupil(child, school)

      await test.step('"Are you Otter?"', async () => {
        await page.goto('/')
        await expect(child.words('class.areYou', { nickname: 'Otter' })).toBeFocused()
        await page.keyboard.press('Escape')
        await page.keyboard.press('Escape')
        await expect(child.words('class.areYou', { nickname: 'Otter' })).toBeFocused()
        await child.tabsTo(child.button('class.yesOn'))
        await page.keyboard.press('Enter')
        await pupil.seesMe()
      })

      await test.step('a raised hand is seen by the teacher', async () => {
        await child.opensLab('friendship')
        await pupil.opensMenu()
        await child.presses('class.raiseHand')
        const handOf = async () => {
          const { body } = await school.teacher.ask('GET', `/classes/${school.id}/live`)
          const { tiles } = body as { tiles: readonly { id: string; handAt: number | null }[] }
          return tiles.find(({ id }) => id === made.id)?.handAt ?? null
        }
        await expect.poll(handOf).not.toBeNull()
      })

      await test.step('an earlier version comes back, and what was before stays one', async () => {
        await child.seesWeight(leftEye, leftWheel, 0.8)
        await pupil.opensMenu()
        await child.presses('class.versions')
        await expect(page.locator('.versions button, ol button, ul button').last()).toBeVisible()
        await page.getByRole('dialog').getByRole('listitem').last().getByRole('button').click()
        await expect(child.button('class.takeVersion')).toBeEnabled()
        await Promise.all([page.waitForEvent('load'), child.presses('class.takeVersion')])
        await child.seesLab()
        await child.seesWeight(leftEye, leftWheel, 0)
      })

      await test.step('of two devices both are kept', async () => {
        await expect(pupil.chip('chipClass')).toBeVisible()
        await saves(made, { base: 3, starts: [0, 1] })
        await child.typesWeight(leftEye, leftWheel, 0.3)
        await expect(page.getByRole('dialog')).toContainText(child.word('class.thisDevice'))
        await child.button('class.goOnWithThis').first().click()
        await expect(page.getByRole('dialog')).toHaveCount(0)
        await expect(pupil.chip('chipClass')).toBeVisible()
      })

      const projectsInClass = async () => {
        const { body } = await made.asker.ask('GET', '/projects')
        return (body as { projects: readonly object[] }).projects.length
      }
      await test.step('what is thrown away is thrown away in the class, and comes back', async () => {
        await expect.poll(projectsInClass).toBe(2)
        const list = new ProjectList(child)
        await list.opens()
        await expect.poll(() => list.names()).toHaveLength(2)
        const [name] = await list.names()
        await list.chooses(name!, 'throw')
        await expect.poll(projectsInClass).toBe(1)
        await child.presses('projects.takeBack')
        await expect.poll(projectsInClass).toBe(2)
      })

      await test.step('a class that has ended leaves nothing on the device', async () => {
        await school.teacher.ask('DELETE', `/classes/${school.id}`, { name: '6a' })
        await expect(child.words('class.ended')).toBeVisible()
        await child.presses('class.toGarden')
        await child.seesTitle()
        await expect(page.getByRole('link', { name: child.word('home.joinClass') })).toBeVisible()
        const databases = () =>
          page.evaluate(async () => (await indexedDB.databases()).map(({ name }) => name))
        await expect.poll(databases).not.toContain(`botgarten-${made.id}`)
      })
    })
  })
}

test.describe('a code that no class has', () => {
  test.use({ complaints: [/404 \(Not Found\)/] })

  test('is looked up at once by Enter, and again', async ({ child, page }) => {
    await child.opensHome()
    await page.getByRole('link', { name: child.word('home.joinClass') }).click()
    const asked = () => page.waitForResponse((answer) => answer.url().endsWith('/look'), { timeout: 5000 })
    await expect(page.getByLabel(child.word('class.codeWord', { number: 1 }))).toBeFocused()
    // Without Enter the page waits six seconds, since a fourth word may follow.
    await page.keyboard.type('abend adler apfel')
    const first = asked()
    await page.keyboard.press('Enter')
    await first
    await expect(child.words('class.refused.noOpenClass')).toBeVisible()
    const second = asked()
    await page.keyboard.press('Enter')
    await second
  })
})
