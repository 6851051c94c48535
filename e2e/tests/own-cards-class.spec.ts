// Rooms: own-cards, class, teacher
import type { Browser } from '@playwright/test'
import { CardMaker } from '../child-own-cards.ts'
import { ProjectList } from '../child-projects.ts'
import { solves, tasks } from '../child-solving.ts'
import { TimeHands } from '../child-time.ts'
import { Child } from '../child.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn, teaches, type MadeClass } from '../made-class.ts'
import { languagesOf } from '../words.ts'

const friendship = tasks.find(({ card }) => card.id === 'friendship')!

for (const language of languagesOf(import.meta.filename)) {
  const test = testInClass(language)
  // Work must not be lost: a fault here gets no further try.
  test.describe.configure({ retries: 0 })

  test.describe(`a card of one's own in a class, in ${language}`, () => {
    test.use({ language })

    /** A child of the class at another device. */
    async function comes(browser: Browser, school: MadeClass, nickname: string) {
      const context = await browser.newContext({ locale: language, baseURL: school.url })
      const pupil = new Child(await context.newPage(), language)
      await signsIn(pupil.page, school, await joins(school, nickname))
      return pupil
    }

    async function seesCard(pupil: Child, title: string) {
      await pupil.seesLab()
      await expect(pupil.page.getByRole('heading', { level: 1 })).toHaveText(title)
    }

    test('the teacher sends it as a program and as a link; a child opens it and solves it', async ({
      child,
      page,
      browser,
      school,
    }) => {
      const pupil = await comes(browser, school, 'Fuchs')
      await pupil.opensHome()
      const maker = new CardMaker(child)
      await teaches(page, school)
      await maker.begins()
      await maker.writes()
      await maker.seesSolved(3, 3)
      await child.presses('cards.putOnShelf')
      await child.presses('cards.shareLink')
      const link = await new ProjectList(child).link()

      // By address: a teacher comes by a bookmark.
      await page.goto(`/teacher?class=${school.id}&view=live`)
      await child.presses('teacher.sendProgram')
      await page
        .getByLabel(child.word('teacher.program'), { exact: true })
        .selectOption({ label: maker.title })
      await child.presses('teacher.send')
      await expect(child.words('teacher.programSent')).toBeVisible()

      await pupil.presses('class.openOffer')
      await seesCard(pupil, maker.title)
      await solves(pupil, friendship)
      await pupil.pressesStart()
      await new TimeHands(pupil).hurries()
      await expect(pupil.words('lab.successTitle').first()).toBeVisible({ timeout: 60_000 })

      // By address: the link that the teacher shares.
      await pupil.page.goto(link)
      await seesCard(pupil, maker.title)
      await pupil.page.context().close()
    })
  })
}
