// Rooms: reward-zoo, content
import { content } from '@botgarten/content/files'
import { Learner } from '../child-learning.ts'
import { ZooVisitor } from '../child-zoo.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const fountain = content.cages.find(({ cage }) => cage.id === 'fountain')!

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the reward zoo in ${language}`, () => {
    test.use({ language })
    const text = fountain.text[language]!

    test('from home on a child guesses, watches and mends, and the cage stays mended', async ({
      child,
      page,
    }) => {
      await child.opensHome()
      await page.getByRole('link', { name: child.word('home.zoo'), exact: true }).click()
      await page.getByRole('link', { name: text.title }).click()
      // Before a guess nothing is shown of what Bo does, and nothing can be changed.
      await expect(page.getByText(text.does.never)).toHaveCount(0)
      await expect(page.getByText(text.mend)).toHaveCount(0)
      await page.getByRole('button', { name: text.guess.wish, exact: true }).click()
      await child.presses('zoo.learn')
      await expect(page.getByText(text.does.never, { exact: true })).toBeVisible()
      await child.presses('zoo.pause')
      await child.presses('zoo.oneMove')

      const slider = page.getByRole('slider', { name: text.mend })
      await expect(slider).toHaveValue('20')
      // By keys: 18 is still too much, 17 is not.
      await slider.focus()
      await child.types('ArrowLeft', 'ArrowLeft')
      await expect(child.words('zoo.mended')).toHaveCount(0)
      await child.types('ArrowLeft')
      await expect(child.words('zoo.task.done')).toBeVisible()
      await expect(child.words('zoo.old')).toBeVisible()
      await child.presses('zoo.learn')
      await expect(page.getByText(text.does.wish, { exact: true })).toBeVisible()

      await page.getByRole('link', { name: child.word('zoo.back'), exact: true }).click()
      const mended = child.words('zoo.mendedOf', { count: 1, of: content.cages.length })
      await expect(mended).toBeVisible()
      await page.reload()
      await expect(mended).toBeVisible()
    })

    test('on the card a child sees the trick, and mends it on the map', async ({ child, page }) => {
      const learner = new Learner(child)
      await child.opensLab('cheating')
      await learner.sees()
      await learner.hurries()
      await child.presses('lab.start')
      await learner.seesEnd()
      const circle = child.word('q.circlePays', { circle: '.+' })
      await expect(page.getByText(new RegExp(circle)).first()).toBeVisible()
      await learner.station(2).click()
      const reward = page.getByRole('textbox', { name: child.word('q.pay.here'), exact: true })
      await expect(reward).toHaveValue('20')
      await reward.fill('10')
      await child.types('Enter', 'Escape')
      await child.presses('lab.start')
      await learner.seesEnd()
      await learner.seesWay(0, 1, 2, 3, 5)
    })
  })
}

for (const [width, height] of [
  [1366, 768],
  [1024, 768],
] as const)
  for (const language of languagesOf(`${import.meta.filename} ${width}`))
    test.describe(`at ${width}x${height} in ${language}`, () => {
      test.use({ language, viewport: { width, height } })

      test('no box of a cage is cut, before or after Bo has learned', async ({ child, page }) => {
        const zoo = new ZooVisitor(child)
        const cut = () =>
          page
            .locator('.cage-screen .pane')
            .evaluateAll((panes) =>
              panes
                .filter(({ scrollHeight, clientHeight }) => scrollHeight > clientHeight + 1)
                .map((pane) => pane.textContent.trim().slice(0, 30)),
            )
        const found: string[] = []
        await zoo.comes()
        for (const cage of content.cages) {
          await zoo.enters(cage)
          found.push(...(await cut()))
          await zoo.guesses(cage)
          await zoo.watches(cage, cage.cage.claim.aLot)
          found.push(...(await cut()))
          await page.getByRole('link', { name: child.word('zoo.back'), exact: true }).click()
        }
        expect(found).toEqual([])
      })
    })
