// Rooms: projects
import type { BrowserContext } from '@playwright/test'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { opensSettings, option } from '../child-cards.ts'
import { ProjectList } from '../child-projects.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf, type Language } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

/** Puts projects of these names on the device, the last one changed last. */
async function keeps(child: Child, ...names: readonly string[]) {
  const list = new ProjectList(child)
  for (const [index, name] of names.entries()) {
    await list.opens()
    await list.opensFile(
      `${name}.json`,
      freeProgram(name, (make) => [make.wait(index)]),
    )
    await expect(child.page.getByRole('heading', { level: 1 })).toHaveText(name)
  }
  await list.opens()
  return list
}

const otherTab = async (context: BrowserContext, language: Language) =>
  new Child(await context.newPage(), language)
const heading = (child: Child) => child.page.getByRole('heading', { level: 1 })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`my projects, in ${language}`, () => {
    test.use({ language })

    test('an empty list says what will lie there; home and the lab lead to it', async ({ child, page }) => {
      await child.opensHome()
      await page.getByRole('link', { name: child.word('parts.myProjects') }).click()
      const list = new ProjectList(child)
      await list.isSeen()
      await expect(child.words('projects.noneTitle')).toBeVisible()
      await list.begins('Maze')
      const title = page.getByRole('heading', { level: 1 })
      await expect(title).toHaveText('Maze')
      await expect(child.canvas.locator('.blocklyDraggable')).toHaveCount(1)
      await title.getByRole('button').click()
      await child.types(...'Den', 'Enter')
      await expect(title).toHaveText('Den')
      await child.seesSaved()
      await child.presses('lab.menu')
      await page.getByRole('link', { name: child.word('parts.myProjects') }).click()
      await list.seesNames('Den')
      await child.presses('projects.new')
      await page
        .getByRole('dialog')
        .getByRole('button', { name: child.card('forward') })
        .click()
      await child.seesLab()
      await expect(title).toHaveText(child.card('forward'))
    })

    test('what was built lies there with its picture, and gets another name', async ({ child }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.4)
      await child.seesSaved()
      const list = new ProjectList(child)
      await list.opens()
      const card = child.card('friendship')
      await list.seesNames(card)
      await expect(list.project(card).locator('svg image')).toHaveCount(1)
      await list.renames(card, 'Mein bester Versuch')
      await list.seesNames('Mein bester Versuch')
      await list.opensProject('Mein bester Versuch')
      await expect(heading(child)).toHaveText('Mein bester Versuch')
      await child.seesWeight(leftEye, leftWheel, 0.4)
    })

    test('a name of spaces is no name, and a name that looks like a page is only a name', async ({
      child,
      page,
    }) => {
      const list = await keeps(child, 'Uno')
      await list.chooses('Uno', 'rename')
      const field = page.getByRole('textbox', { name: child.word('projects.name') })
      await field.fill('   ')
      await expect(child.button('projects.take')).toHaveAttribute('aria-disabled', 'true')
      await field.fill('<img src=x onerror=alert(1)>')
      await child.presses('projects.take')
      await list.seesNames('<img src=x onerror=alert(1)>')
    })

    test('a copy goes its own way', async ({ child }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.4)
      await child.seesSaved()
      const list = new ProjectList(child)
      await list.opens()
      const card = child.card('friendship')
      const copy = child.word('session.copy', { name: card })
      await list.chooses(card, 'duplicate')
      await list.seesNames(copy, card)
      await list.opensProject(copy)
      await child.typesWeight(leftEye, leftWheel, 0.9)
      await child.seesSaved()
      await child.opensLab('friendship')
      await child.seesWeight(leftEye, leftWheel, 0.4)
    })

    test('the bin gives back at once and later, and forgets only when it is emptied', async ({ child }) => {
      const list = await keeps(child, 'Uno', 'Due')
      await list.chooses('Due', 'throw')
      await list.hears('projects.thrown', { name: 'Due' })
      await list.seesNames('Uno')
      await child.presses('projects.takeBack')
      await list.seesNames('Due', 'Uno')

      await list.chooses('Uno', 'throw')
      await list.seesNames('Due')
      await list.goesToBin()
      await expect(list.inBin('Uno')).toContainText(child.word('projects.days', { days: 30 }))
      await child.presses('projects.takeBack')
      await expect(child.words('projects.binEmpty')).toBeVisible()

      await list.opens()
      await list.seesNames('Due', 'Uno')
      await list.chooses('Uno', 'throw')
      await list.hears('projects.thrown', { name: 'Uno' })
      await list.goesToBin()
      await child.presses('projects.emptyBin')
      await child.presses('projects.cancel')
      await expect(list.inBin('Uno')).toBeVisible()
      await child.presses('projects.emptyBin')
      await child.presses('projects.emptyYes')
      await expect(child.words('projects.binEmpty')).toBeVisible()
      await list.opens()
      await list.seesNames('Due')
    })

    test('among many one searches, and puts them in order', async ({ child, page }) => {
      const names = ['Möwe 10', 'Möwe 9', 'C', 'D', 'E', 'F', 'G', 'H', 'I']
      const list = await keeps(child, ...names)
      await list.seesNames(...names.toReversed())
      await page.getByRole('searchbox').fill('möwe')
      await list.seesNames('Möwe 9', 'Möwe 10')
      await page.getByRole('searchbox').fill('nichts davon')
      await expect(child.words('projects.nothingFound')).toBeVisible()
      await page.getByRole('searchbox').fill('')
      await page.getByRole('combobox').selectOption('name')
      await list.seesNames('C', 'D', 'E', 'F', 'G', 'H', 'I', 'Möwe 9', 'Möwe 10')
    })

    test('a project that another tab throws away is not lost in this one', async ({ child, context }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.4)
      await child.seesSaved()
      const other = await otherTab(context, language)
      const list = new ProjectList(other)
      await list.opens()
      const card = child.card('friendship')
      await expect(list.project(card)).toContainText(child.word('projects.elsewhere'))
      await list.chooses(card, 'throw')
      await expect(child.dialog('lab.goneTitle')).toContainText(child.word('lab.goneText'))
      await child.presses('lab.goneKeep')
      await child.seesSaved()
      await child.typesWeight(rightEye, rightWheel, 0.2)
      await child.seesSaved()
      await child.reloads()
      await child.seesWeight(leftEye, leftWheel, 0.4)
      await child.seesWeight(rightEye, rightWheel, 0.2)
    })

    test('everything goes home as one file, and lies beside what is there', async ({ child, browser }) => {
      const list = await keeps(child, 'Uno', 'Due')
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.4)
      await child.seesSaved()
      await list.opens()
      const file = await list.takesHome()

      const context = await browser.newContext({ locale: language, baseURL: child.page.url() })
      const home = new Child(await context.newPage(), language)
      const there = new ProjectList(home)
      await home.opensLab('friendship')
      await home.typesWeight(leftEye, leftWheel, 0.9)
      await home.seesSaved()
      await there.opens()
      await there.opensFile('home.botgarten.json', file)
      await there.isTold('projects.mergedTitle', 'projects.merged', { added: 3, same: 0 })
      const copy = home.word('session.copy', { name: home.card('friendship') })
      await expect
        .poll(async () => (await there.names()).toSorted())
        .toEqual([copy, home.card('friendship'), 'Uno', 'Due'].toSorted())
      await there.opensFile('home.botgarten.json', file)
      await there.isTold('projects.mergedTitle', 'projects.merged', { added: 0, same: 3 })
      await home.opensLab('friendship')
      await home.seesWeight(leftEye, leftWheel, 0.9)
      // The home page takes such a file too.
      await home.opensHome()
      await home.opensFileAtHome('home.botgarten.json', file)
      await there.isTold('projects.mergedTitle', 'projects.merged', { added: 0, same: 3 })
      await context.close()
    })

    test('the bin and the settings go home too; what is set at home stays', async ({ child, browser }) => {
      const list = await keeps(child, 'Uno', 'Due')
      await list.chooses('Due', 'throw')
      await list.hears('projects.thrown', { name: 'Due' })
      await child.opensHome()
      await opensSettings(child, 'home')
      await option(child, 'letters').click()
      await list.opens()
      const file = await list.takesHome()

      const context = await browser.newContext({ locale: language, baseURL: child.page.url() })
      const home = new Child(await context.newPage(), language)
      const there = new ProjectList(home)
      await there.opens()
      await there.opensFile('home.botgarten.json', file)
      const dialog = home.dialog('projects.mergedTitle')
      await expect(dialog).toContainText(home.word('projects.mergedBin', { binned: 1 }))
      await expect(dialog).toContainText(home.word('projects.mergedSettings'))
      // At once, and after a reload.
      await expect(home.page.locator('html')).toHaveAttribute('data-letters')
      await home.page.reload()
      await there.seesNames('Uno')
      await expect(home.page.locator('html')).toHaveAttribute('data-letters')
      await there.goesToBin()
      await expect(there.inBin('Due')).toHaveCount(1)

      // Another option is there by now.
      await home.opensHome()
      await opensSettings(home, 'home')
      await option(home, 'letters').click()
      await there.opens()
      await there.opensFile('home.botgarten.json', file)
      await expect(dialog).toContainText(home.word('projects.keptSettings'))
      await expect(dialog).not.toContainText(home.word('projects.mergedSettings'))
      await expect(home.page.locator('html')).not.toHaveAttribute('data-letters')
      await there.goesToBin()
      await expect(there.inBin('Due')).toHaveCount(1)
      await context.close()
    })

    test('a home file that is broken is refused with a reason; a broken project in it is left out', async ({
      child,
    }) => {
      const list = await keeps(child, 'Uno')
      const file = JSON.parse(await list.takesHome()) as { projects: unknown[] }
      await list.opensFile('x.json', '{"botgartenHome":1}')
      await list.isTold('problem.notAProject.title', 'problem.notAProject.text')
      await list.opensFile('x.json', '{"botgartenHome":9,"projects":[]}')
      await list.isTold('problem.newerVersion.title', 'problem.newerVersion.text', { version: 9 })
      await list.opensFile('x.json', '{"botgartenHome":1,"projects":[')
      await list.isToldOfAnEarlierClosing('problem.notJson.title')
      await list.isTold('problem.notJson.title', 'problem.notJson.text')
      file.projects.push({ id: 'x', changed: 1, project: { botgarten: 1 } })
      await list.opensFile('x.json', JSON.stringify(file))
      await list.isTold('projects.mergedTitle', 'projects.mergedBroken', { broken: 1 })
      await list.seesNames('Uno')
    })

    test('says where a device forgets', async ({ child }) => {
      await keeps(child, 'Uno')
      await expect(child.page.getByText(child.word('projects.keptHere'))).toBeVisible()
      await expect(child.page.getByText(child.word('projects.forgets'))).toBeVisible()
    })

    test('a browser that keeps nothing says so on the list', async ({ child, page }) => {
      await page.addInitScript(() => {
        Object.defineProperty(IDBFactory.prototype, 'open', {
          value: () => {
            throw new DOMException('Refused for a test.', 'SecurityError')
          },
        })
      })
      const list = new ProjectList(child)
      await list.opens()
      await expect(page.getByText(child.word('projects.keptNowhereText'))).toBeVisible()
      await list.opensFile(
        'uno.json',
        freeProgram('Uno', (make) => [make.wait(1)]),
      )
      await list.isTold('problem.notKept.title', 'problem.notKept.text')
    })
  })
}
