import type { Child } from '../../child.ts'
import { ProofHands } from '../../child-proof.ts'
import { SortingHands } from '../../child-sorting.ts'
import { fixesDice } from '../../navigation.ts'
import { expect, follows, opensCard, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

const press =
  (key: string, facts = {}) =>
  (child: Child) =>
    child.presses(`sorting.${key}`, facts)

test('things are sorted, step by step', { tag: '@sorting' }, async ({ child, page }) => {
  const sorting = new SortingHands(child)
  const proof = new ProofHands(child)
  const game = child.dialog('sorting.guess.title')
  const list = (key: string) => page.getByRole('combobox', { name: sorting.word(key), exact: true })
  const says = (key: string) => () =>
    game.getByRole('button', { name: sorting.word(key), exact: true }).click()
  const moves = async (act: () => Promise<unknown>) => {
    const before = await sorting.places()
    await act()
    await expect.poll(() => sorting.places()).not.toEqual(before)
  }
  await goesThrough(child, 'sorting', {
    'the playground': async () => {
      await child.opensHome()
      await fixesDice(child)
      await follows(child, 'home.sorting')
      await expect(sorting.flags).toHaveCount(3)
    },
    'one thing joins': press('joinOne'),
    'all join': press('join'),
    'one flag moves': () => moves(() => press('moveOne')(child)),
    'all flags move': () => moves(() => press('move')(child)),
    'a step back': press('back'),
    'a step forth': press('forth'),
    'back along the line': () => page.getByRole('slider', { name: sorting.word('wayBack') }).press('Home'),
    'a thing is touched': () => sorting.thing('bottle', 1).click(),
    'it is let go': () => sorting.thing('bottle', 1).click(),
    'a key goes to a thing': () => sorting.plane.press('ArrowRight'),
    'a key leaves it': () => sorting.plane.press('Escape'),
    'how flags are placed': press('placeHow'),
    'the best of many': press('start.best'),
    'how they are placed now': press('placeHow'),
    'far apart': press('start.far'),
    'it plays faster, to the end': async () => {
      await press('speed', { speed: '1×' })(child)
      await press('play')(child)
      await expect(child.button('sorting.pause')).toBeVisible()
      await sorting.seesDone()
      await expect(child.button('sorting.play')).toBeVisible()
    },
    'how the number comes about': () => proof.asks(),
    'it is known': () => proof.closes(),
    'a flag is moved by key': () => moves(() => sorting.flag(1).press('ArrowLeft')),
    'it is taken back': () => moves(() => sorting.plane.press('Control+z')),
    'a flag is pulled': () =>
      moves(async () => child.drags(await child.middleOf(sorting.flag(1)), await sorting.middleOfPlane())),
    'it begins again': press('again'),
    'more flags': press('moreFlags'),
    'fewer flags': press('fewerFlags'),
    'a group has a name': () => sorting.group(1).fill('Bottles'),
    'another distance': () => list('howFar').selectOption('manhattan'),
    'a feature more counts': () => page.getByRole('switch', { checked: false }).first().click(),
    'another axis': () => list('axisX').selectOption({ index: 2 }),
    'one feature counts': async () => {
      const on = page.getByRole('switch', { checked: true })
      while ((await on.count()) > 1) await on.first().click()
    },
    'only words count': async () => {
      await page.getByRole('switch', { name: sorting.word('feature.material') }).click()
      await page.getByRole('switch', { checked: true }).first().click()
    },
    'nothing counts': () => page.getByRole('switch', { checked: true }).click(),
    'another set': () => list('whichSet').selectOption({ index: 1 }),
    'the first set': () => list('whichSet').selectOption({ index: 0 }),
    'a hint': (one) => one.presses('lab.hint'),
    'the next hint': (one) => one.presses('lab.hintNext'),
    'the last hint': (one) => one.presses('lab.hintNext'),
    'the hint before': (one) => one.presses('lab.hintBefore'),
    'no hint': (one) => one.presses('parts.close'),
    'two guess': press('guess.open'),
    'a feature is chosen in secret': says('feature.height'),
    'things are sorted by it': says('guess.sort'),
    'the next round': says('guess.next'),
    'the other is asked': async () => {
      const asked = game.getByText(sorting.word('guess.second'))
      while (!(await asked.isVisible())) await says('guess.next')()
    },
    'a wrong guess': async () => {
      await says('feature.colour')()
      await says('guess.check')()
    },
    'a right guess': async () => {
      await says('feature.colour')()
      await says('feature.height')()
      await says('guess.check')()
    },
    'they swap': says('guess.swap'),
    'the other gives up': async () => {
      await says('feature.colour')()
      await says('guess.sort')()
      const asked = game.getByText(sorting.word('guess.second'))
      while (!(await asked.isVisible())) await says('guess.next')()
      await says('guess.show')()
    },
    'the game is closed': () => game.getByRole('button', { name: child.word('parts.close') }).click(),
  })
})

test('points and readings are sorted, step by step', { tag: '@sorting' }, async ({ child, page }) => {
  const sorting = new SortingHands(child)
  const points = page.getByRole('combobox', { name: sorting.word('pointsFrom') })
  const at = async (x: number, y: number) => {
    const middle = await sorting.middleOfPlane()
    await page.mouse.click(middle.x + x, middle.y + y)
  }
  const empties = async () => {
    await sorting.presses('drive.empty')
    await expect(sorting.words('noReadings')).toBeVisible()
  }
  await goesThrough(child, 'sorting-points', {
    points: async () => {
      await child.opensHome()
      await fixesDice(child)
      await follows(child, 'home.sorting')
      await sorting.presses('tab.points')
    },
    'a trap': () => points.selectOption('outlier'),
    'own points': () => points.selectOption(''),
    'a pen': press('tool.add'),
    'two points by hand': async () => {
      await at(-150, -100)
      await at(150, 100)
    },
    'a point by key': async () => {
      await sorting.plane.focus()
      await child.types('ArrowUp', 'ArrowUp', 'Enter')
    },
    'a rubber': press('tool.remove'),
    'a point is taken away': () => at(-150, -100),
    'a point is touched by key': async () => {
      await sorting.presses('tool.look')
      await sorting.plane.press('ArrowRight')
    },
    'it is deleted': () => sorting.plane.press('Delete'),
    'a table that can be either': async () => {
      const [chooser] = await Promise.all([page.waitForEvent('filechooser'), sorting.presses('openTable')])
      const buffer = Buffer.from('1,5\n2,25\n9,75\n')
      await chooser.setFiles({ name: 'table.csv', mimeType: 'text/csv', buffer })
    },
    'it has one column': press('table.oneColumn'),
    'a broken table': () => sorting.opensTable('Length;Width\n1;x\n'),
    readings: press('tab.readings'),
    'Bo drives in lanes, and its readings are thrown away': async () => {
      await sorting.presses('drive.lanes')
      await expect(sorting.words('noReadings')).toHaveCount(0)
      await expect(child.button('sorting.drive.empty')).toHaveAttribute('aria-disabled', 'true')
      await sorting.presses('drive.stop')
      await empties()
      await sorting.presses('moreFlags')
    },
    'Bo drives by hand and by key': async () => {
      const forward = child.button('sorting.drive.forward')
      const { x, y } = await child.middleOf(forward)
      await page.mouse.move(x, y)
      await page.mouse.down()
      await expect(sorting.words('noReadings')).toHaveCount(0)
      await page.mouse.up()
      await empties()
      await child.button('sorting.drive.back').focus()
      await page.keyboard.down('Enter')
      await expect(sorting.words('noReadings')).toHaveCount(0)
      await page.keyboard.up('Enter')
      await empties()
      await sorting.presses('fewerFlags')
    },
    'a card of sorting': () => opensCard(child, 'tidy-up'),
    'what it has collected': async () => {
      await child.presses('lab.menu')
      await child.presses('robot.sorting')
    },
    'its program': () => page.getByRole('link', { name: sorting.word('toProgram') }).click(),
    'a project that is not there': async () => {
      // By address: a link to a project of another device.
      await page.goto('/sorting?p=nobody')
      await expect(page.getByText(sorting.word('say.missing'))).toBeVisible()
    },
  })
})
