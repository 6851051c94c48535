// Rooms: sorting, projects, storage, share
import { readFile } from 'node:fs/promises'
import { Child } from '../child.ts'
import { ProjectList } from '../child-projects.ts'
import { SortingHands } from '../child-sorting.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`sorting as a project, in ${language}`, () => {
    test.use({ language })

    async function makes(child: Child): Promise<SortingHands> {
      const sorting = new SortingHands(child)
      await sorting.makesMarbles()
      await child.seesSaved()
      return sorting
    }
    const fromMenu = async (child: Child, word: string) => {
      await child.presses('lab.menu')
      await child.presses(word)
    }

    test('every data set is there with its result after a reload, and undo leads across them', async ({
      child,
      page,
    }) => {
      const sorting = await makes(child)
      await sorting.takesPoints('few')
      await sorting.sorts()
      await sorting.opensTable('Länge;Breite\n1,5;2\n9,5;8\n1,25;2,5\n9;9\n2;2\n')
      await sorting.seesPoints(5)
      await sorting.presses('tab.things')
      await sorting.sorts()
      await child.seesSaved()
      await page.reload()
      await sorting.seesDone()
      await sorting.presses('tab.points')
      await sorting.seesPoints(5)
      await sorting.takesPoints('few')
      await sorting.seesDone()
      await sorting.takesPoints('')
      await sorting.seesMarbles()
      await sorting.presses('clearPoints')
      await expect(sorting.words('noPoints')).toBeVisible()
      await child.types('Control+z')
      await sorting.seesMarbles()
      await child.types('Control+z')
      await sorting.seesPoints(60)
    })

    test('a link opens it on another device; mine stays as it is', async ({ child, browser }) => {
      const mine = await makes(child)
      await fromMenu(child, 'parts.share')
      const link = await new ProjectList(child).link()
      const context = await browser.newContext({ locale: language })
      const friend = new Child(await context.newPage(), language)
      // By address: it is a link.
      await friend.page.goto(link)
      const theirs = new SortingHands(friend)
      await theirs.seesMarbles()
      await theirs.group(1).fill('Theirs')
      await friend.seesSaved()
      await friend.page.reload()
      await expect(theirs.group(1)).toHaveValue('Theirs')
      await context.close()
      await child.page.reload()
      await mine.seesMarbles()
    })

    test('a file opens it again, next to the one that is there', async ({ child, page }) => {
      await makes(child)
      const [download] = await Promise.all([page.waitForEvent('download'), fromMenu(child, 'lab.saveFile')])
      const text = await readFile(await download.path(), 'utf8')
      expect(JSON.parse(text)).toMatchObject({ botgarten: 5, playground: 'sorting', name: 'Marbles' })
      await child.opensHome()
      await child.opensFileAtHome('Marbles.botgarten.json', text)
      await new SortingHands(child).seesMarbles()
      const list = new ProjectList(child)
      await list.opens()
      await list.seesNames('Marbles', 'Marbles')
    })

    test('it is copied, deleted and restored like every project, and a new one begins empty', async ({
      child,
      page,
    }) => {
      const sorting = await makes(child)
      const list = new ProjectList(child)
      await list.opens()
      await list.chooses('Marbles', 'throw')
      await list.hears('projects.thrown', { name: 'Marbles' })
      await list.seesNames()
      await sorting.opens('points')
      await sorting.seesPoints(42)
      await list.opens()
      await list.goesToBin()
      await list
        .inBin('Marbles')
        .getByRole('button', { name: child.word('projects.takeBack') })
        .click()
      await list.opens()
      await page.getByRole('link', { name: 'Marbles', exact: true }).click()
      await sorting.seesMarbles()
      await fromMenu(child, 'sorting.new')
      await expect(sorting.title).toHaveText(sorting.word('newName'))
      await expect(sorting.flags).toHaveCount(3)
      await expect(sorting.group(1)).toHaveValue('')
    })

    test('of two tabs the second one is asked, and nothing is overwritten', async ({ child, context }) => {
      await makes(child)
      const other = new Child(await context.newPage(), language)
      const theirs = new SortingHands(other)
      await theirs.opens()
      await theirs.seesMarbles()
      await new SortingHands(child).group(2).fill('First tab')
      await child.seesSaved()
      await expect(other.dialog('lab.conflictTitle')).toBeVisible()
      await other.presses('lab.keepCopy')
      await theirs.group(2).fill('Second tab')
      await other.seesSaved()
      await other.page.reload()
      await expect(theirs.title).toHaveText(other.word('session.copy', { name: 'Marbles' }))
      await expect(theirs.group(2)).toHaveValue('Second tab')
      await child.page.reload()
      await expect(new SortingHands(child).group(2)).toHaveValue('First tab')
    })
  })
}
