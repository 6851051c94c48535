import { opensSettings, option } from '../child-cards.ts'
import { expect, opensCard, test, title } from './gate.ts'

test.use({ language: 'en' })

test(
  'the first card is missed and then solved; home shows how far the child is and leads on',
  {
    tag: ['@home', '@missed', '@/', '@/lab/[card]'],
  },
  async ({ child, page }) => {
    await opensCard(child, 'forward')
    await child.pressesStart()
    await expect(child.button('lab.start').first()).toBeVisible()
    await child.seesCheck('forward', 'arrives', false)
    // 170 cm lead to the flag, and 50 were driven.
    const gap = child.word('missed.arrives.before', { place: 'flag', away: '1.2 m' })
    await expect(page.getByText(gap)).toBeVisible()
    await child.typesNumber('driveDistance', '170')
    await child.presses('lab.resetWorld')
    await child.pressesStart()
    await child.seesCheck('forward', 'arrives')
    await expect(page.getByText(gap)).toHaveCount(0)
    await expect(child.words('lab.successTitle')).toBeVisible()
    await child.seesSaved()
    await page
      .getByRole('link', { name: child.word('lab.successCard', { name: child.card('square') }) })
      .click()
    await expect(title(page)).toHaveText(child.card('square'))

    await page.getByRole('link', { name: child.word('parts.home') }).click()
    const done = child.word('home.level', { passed: 1, of: 1 })
    await expect(page.getByRole('img', { name: done })).toHaveCount(1)
    await page.getByRole('button', { name: child.word('home.free') }).click()
    await page.getByLabel(child.word('projects.name'), { exact: true }).fill('Maze')
    await page.keyboard.press('Enter')
    await child.seesLab()
    await expect(title(page)).toHaveText('Maze')
  },
)

test(
  'settings and language are kept: clear letters, large words, no Bo, sound off, German',
  {
    tag: ['@home', '@/'],
  },
  async ({ child, page }) => {
    await child.opensHome()
    await opensSettings(child, 'home')
    for (const name of ['projector', 'quiet', 'letters'] as const) {
      await option(child, name).click()
      await expect(option(child, name)).toBeChecked()
    }
    await child.types('Escape')
    await child.speaks('de')
    await expect(page.locator('html')).toHaveAttribute('lang', 'de')
    await (await child.findsCard('friendship')).click()
    await child.seesLab()
    await expect(title(page)).toHaveText('Freundschaft')
    const font = await title(page).evaluate((one) => getComputedStyle(one).fontFamily)
    expect(font).toContain('Atkinson')
    await expect(page.locator('html')).toHaveAttribute('data-projector')
    await expect(page.locator('.strip .peek')).toBeHidden()
    await child.presses('lab.soundOff')
    await child.reloads()
    await expect(child.button('lab.soundOn').first()).toBeVisible()
    await opensSettings(child, 'lab')
    await option(child, 'quiet').click()
    await child.types('Escape')
    await expect(page.locator('.strip .peek')).toBeVisible()
  },
)
