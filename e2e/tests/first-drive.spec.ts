// Rooms: content, home, lab
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

test.use({ motion: true })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`in ${language}`, () => {
    test.use({ language })

    test("home's first bed leads to a card that is solved in a minute, and on to the next", async ({
      child,
      page,
    }) => {
      await child.opensHome()
      await page.getByRole('link', { name: child.card('forward'), exact: true }).click()
      await child.seesLab()
      await child.pressesStart()
      await expect(child.button('lab.start').first()).toBeVisible()
      await child.seesCheck('forward', 'arrives', false)
      await child.typesNumber('driveDistance', '170')
      await child.presses('lab.resetWorld')
      await child.pressesStart()
      await child.seesCheck('forward', 'arrives')
      await page
        .getByRole('link', { name: child.word('lab.successCard', { name: child.card('square') }) })
        .click()
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.card('square'))
      await child.opensHome()
      const done = child.word('home.level', { passed: 1, of: 1 })
      await expect(page.getByRole('img', { name: done })).toHaveCount(1)
    })

    test('the square: turning further and repeating more often leads around the bed', async ({ child }) => {
      await child.opensLab('square')
      await child.typesNumber('times', '4')
      await child.typesNumber('turnDegree', '90')
      await child.pressesStart()
      await new TimeHands(child).hurries()
      await child.seesCheck('square', 'corners')
      await child.seesCheck('square', 'home')
    })

    test('the wall: Bo bumps at 0 and stops in time at 25, from both places, by keys alone', async ({
      child,
      page,
    }) => {
      await child.opensLab('stop')
      await child.tabsAndPresses('lab.start')
      await new TimeHands(child).hurriesByKeys()
      await expect(page.locator('.banner', { hasText: child.word('world.bumped') })).toBeVisible()
      // The program drives both wheels alike, so the question about the faster one does not appear.
      await expect(page.getByText(child.word('session.bumped'))).toHaveCount(0)
      await child.types('Escape')
      await child.typesNumber('limit', '25')
      await child.tabsAndPresses('lab.resetWorld')
      await child.tabsAndPresses('lab.start')
      await child.seesCheck('stop', 'neverTouches')
      await child.seesCheck('stop', 'stays')
      await child.presses('lab.successStart', { number: 2 })
      await expect(child.button('lab.placePassed', { number: 2 })).toBeVisible()
    })

    test('a card of the first drive is laid open and says what is needed', async ({ child, page }) => {
      await page.emulateMedia({ reducedMotion: 'reduce' })
      await child.opensLab('stop')
      await child.presses('lab.card')
      await expect(page.getByRole('dialog')).toContainText(child.word('lab.firstDrive'))
      await expect(page.getByRole('dialog')).toContainText(child.word('lab.needWall'))
    })
  })
}

test('what a hand has helped with is not cheered: it is said, and leads to the start place', async ({
  child,
  page,
}) => {
  await child.opensLab('forward')
  await child.typesNumber('driveDistance', '170')
  await child.pressesStart()
  await child.bo.focus()
  await child.types('ArrowUp')
  await new TimeHands(child).hurries()
  await expect(page.getByText(child.word('lab.uncountedText'))).toBeVisible()
  await child.seesCheck('forward', 'arrives')
  await expect(page.getByText(child.word('lab.successTitle'))).toHaveCount(0)
  await child.presses('lab.uncountedAgain')
  await child.seesCheck('forward', 'arrives', false)
  await child.presses('lab.start')
  await expect(page.getByText(child.word('lab.successTitle'))).toBeVisible()
})

test('a lab that was opened to drive at once waits after a reload, at the rest of its address', async ({
  child,
  page,
}) => {
  await child.opensHome()
  await page.getByRole('link', { name: child.word('home.drive') }).click()
  await expect(child.button('lab.stop').first()).toBeVisible()
  await expect(page).toHaveURL(/\/lab\/free$/)
  await child.reloads()
  await child.seesStanding()
  // By address: a link may have further parameters.
  await page.goto('/lab/free?start&dice=1')
  await expect(page).toHaveURL(/\/lab\/free\?dice=1$/)
})
