// Rooms: reward-zoo, content
import { content } from '@botgarten/content/files'
import { SenseVisitor } from '../child-sense-zoo.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const spinner = content.senseCages.find(({ cage }) => cage.id === 'spinner')!

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the loophole zoo in ${language}`, () => {
    test.use({ language })

    test('from home on a child predicts, watches Bo turn, mends the pay, and the cage stays mended', async ({
      child,
      page,
    }) => {
      const zoo = new SenseVisitor(child)
      await zoo.comes()
      await zoo.enters(spinner)
      // Before a guess nothing is shown of what Bo does, and nothing can be changed.
      await expect(page.getByText(spinner.text[language]!.does.cheats)).toHaveCount(0)
      await expect(child.button('zoo.senses.add')).toHaveCount(0)
      await zoo.guesses(spinner)
      await zoo.watches(spinner)
      // A coin for each moment falls at its head.
      await expect(page.locator('figure svg text')).toHaveText(language === 'de' ? '+1,0' : '+1.0')

      // Pay beyond 20 coins goes to 20; without any there is nothing to learn for.
      const coins = page.getByRole('spinbutton', {
        name: child.word('zoo.senses.coins', { number: 1 }),
        exact: true,
      })
      await coins.fill('1000000')
      await coins.press('Tab')
      await expect(coins).toHaveValue('20')
      await child.presses('zoo.senses.remove', { number: 2 })
      await coins.fill('0')
      await coins.press('Tab')
      await expect(child.words('zoo.senses.nothing')).toBeVisible()
      await expect(child.button('zoo.senses.try')).toHaveAttribute('aria-disabled', 'true')
      await child.presses('zoo.senses.restore')

      await zoo.mends(spinner)
      await zoo.triesUntilMended()
      await zoo.leaves()
      await expect(child.words('zoo.mended')).toBeVisible()
      await page.reload()
      await expect(child.words('zoo.mended')).toBeVisible()
    })
  })
}
