import { SortingHands } from '../child-sorting.ts'
import { ProjectList } from '../child-projects.ts'
import { expect, follows, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'things are sorted to the end, each is in the group of its nearest flag, and groups keep their names',
  {
    tag: ['@sorting', '@/sorting'],
  },
  async ({ child, page }) => {
    const sorting = new SortingHands(child)
    await follows(child, 'home.sorting')
    await expect(sorting.flags).toHaveCount(3)
    const before = await sorting.places()
    await sorting.presses('play')
    await sorting.seesDone()
    await expect.poll(() => sorting.places()).not.toEqual(before)
    const kinds = ['bottle', 'cup', 'glass'].map((kind) => sorting.word(`kind.${kind}`)).join('|')
    for (const number of [1, 5, 9])
      await test.step(`thing ${number}`, async () => {
        await page.getByRole('button', { name: new RegExp(`^(${kinds}) ${number}$`) }).click()
        const said = page.getByText(new RegExp(sorting.word('awayFrom', { flag: 1, away: '[\\d,]+' })))
        const text = (await said.textContent())!
        const away = [1, 2, 3].map((flag) => {
          const words = new RegExp(sorting.word('awayFrom', { flag, away: '([\\d,]+)' }))
          return Number(words.exec(text)![1]!.replace(',', '.'))
        })
        const nearest = away.indexOf(Math.min(...away)) + 1
        expect(text).toContain(sorting.word('inGroup', { flag: nearest }))
      })
    await sorting.group(1).fill('Flaschen')
    await child.drags(await child.middleOf(sorting.flag(1)), await sorting.middleOfPlane())
    await expect(sorting.words('say.done')).toHaveCount(0)
    await child.seesSaved()
    await page.reload()
    await expect(sorting.group(1)).toHaveValue('Flaschen')
  },
)

test(
  'points of a table and readings of Bo are sorted, and a criterion is guessed',
  {
    tag: ['@sorting', '@/sorting'],
  },
  async ({ child, page }) => {
    const sorting = new SortingHands(child)
    await follows(child, 'home.sorting')
    await sorting.presses('tab.points')
    await sorting.opensTable('Länge;Breite\n1,5;2\n9,5;8\n1,25;2,5\n9;9\n')
    await sorting.seesPoints(4)
    await sorting.sorts()
    await sorting.presses('tab.readings')
    await expect(sorting.words('noReadings')).toBeVisible()
    await sorting.presses('drive.lanes')
    await expect(sorting.words('noReadings')).toHaveCount(0)
    const some = new RegExp(`^[1-9]\\d ${sorting.word('readingCount', { count: '' }).trim()}$`)
    await expect(page.getByText(some)).toBeVisible()
    await sorting.presses('drive.stop')
    await sorting.presses('play')
    await sorting.seesDone()

    await sorting.presses('tab.things')
    await sorting.presses('guess.open')
    const game = child.dialog('sorting.guess.title')
    const press = (key: string) => game.getByRole('button', { name: sorting.word(key), exact: true }).click()
    await press('feature.height')
    await press('guess.sort')
    const asked = game.getByText(sorting.word('guess.second'))
    await expect(game.getByText(sorting.word('guess.watch')).or(asked)).toBeVisible()
    while (!(await asked.isVisible())) await press('guess.next')
    await press('feature.colour')
    await press('guess.check')
    await expect(game.getByText(sorting.word('guess.wrong', { found: 0, of: 1 }))).toBeVisible()
    await press('feature.colour')
    await press('feature.height')
    await press('guess.check')
    const right = sorting.word('guess.right', { list: sorting.word('feature.height') })
    await expect(game.getByText(right)).toBeVisible()
    await expect(page.getByRole('dialog')).toHaveCount(1)
  },
)

test(
  'own points stay while others are looked at, how many flags fit them is a curve, and all of it is a project',
  {
    tag: ['@sorting', '@/sorting', '@projects', '@/projects'],
  },
  async ({ child, page }) => {
    const sorting = new SortingHands(child)
    await follows(child, 'home.sorting')
    await sorting.presses('tab.points')
    await sorting.draws([-150, -100], [150, 100], [120, 90])
    await sorting.takesPoints('moons')
    await sorting.seesPoints(64)
    await sorting.takesPoints('few')
    await sorting.presses('howMany.title')
    const curve = child.dialog('sorting.howMany.title')
    await expect(curve).toContainText(sorting.word('howMany.found', { flags: 5 }))
    await curve.getByRole('button', { name: '5', exact: true }).click()
    await curve.getByRole('button', { name: child.word('parts.close'), exact: true }).click()
    await expect(sorting.flags).toHaveCount(5)
    await sorting.takesPoints('')
    await sorting.seesPoints(3)
    await sorting.sorts()
    await sorting.renames('Murmeln')
    await child.seesSaved()
    const list = new ProjectList(child)
    await list.opens()
    await list.seesNames('Murmeln')
    await page.getByRole('link', { name: 'Murmeln', exact: true }).click()
    await expect(sorting.title).toHaveText('Murmeln')
    await sorting.seesPoints(3)
    await sorting.seesDone()
  },
)
