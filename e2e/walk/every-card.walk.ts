import { Learner } from '../child-learning.ts'
import { isRaced, racesBrains } from '../child-racing.ts'
import { solves, tasks } from '../child-solving.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { settingsOf, variantsOf } from '../variant.ts'

for (const { task, variant } of tasks.flatMap((task) =>
  variantsOf(task.card.id).map((variant) => ({ task, variant })),
)) {
  const { card } = task
  const of = card.starts.length

  test.describe(`${card.id} in ${variant.language}, by ${variant.hand}`, () => {
    test.use(settingsOf(variant))

    test(`is solved from ${of} ${of === 1 ? 'place' : 'places'}, to the end`, async ({ child, page }) => {
      const time = new TimeHands(child)
      // At full speed it may be passed before anybody looks.
      const place = (number: number) =>
        child.button('lab.place', { number }).or(child.button('lab.placePassed', { number }))
      await child.opensLab(card.id)
      await solves(child, task)
      if (isRaced(task)) await racesBrains(child)

      for (let number = 1; number <= of; number += 1)
        await test.step(`from place ${number}`, async () => {
          if (of > 1) await expect(place(number)).toHaveAttribute('aria-pressed', 'true')
          if (card.playground === 'q-learning') await new Learner(child).hurries()
          // The next place starts by itself.
          if (number === 1 || card.playground === 'q-learning') await child.presses('lab.start')
          if (card.playground === 'q-learning') await new Learner(child).seesEnd()
          if (number === 1) await time.hurries()
          const success = page.getByText(child.word('lab.successTitle'), { exact: true })
          await expect(success).toBeVisible({ timeout: 120_000 })
          for (const { id } of card.checks) await child.seesCheck(card.id, id)
          if (of > 1) await expect(child.button('lab.placePassed', { number })).toBeVisible()
          if (number < of) await child.presses('lab.successStart', { number: number + 1 })
        })

      await test.step('what comes next is offered, and home shows that all is done', async () => {
        const [onTo, address] = card.next
          ? [child.word('lab.successCard', { name: child.card(card.next) }), `/lab/${card.next}$`]
          : card.place
            ? [child.word('lab.successZoo'), '/zoo$']
            : [child.word('lab.successHome'), '/$']
        const next = page.getByRole('link', { name: onTo, exact: true })
        await expect(next).toHaveAttribute('href', new RegExp(address))
        await child.seesSaved()
        if (card.next) {
          await child.press(next)
          await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.card(card.next))
        }
        await child.opensHome()
        await child.findsCard(card.id)
        const full = child.word('home.level', { passed: of, of })
        // A chapter of one card has it large, in no list.
        const own = page
          .getByRole('listitem')
          .or(page.locator('.next'))
          .filter({ has: page.locator(`a[href$="/lab/${card.id}"]`) })
        await expect(own.getByRole('img', { name: full, exact: true })).toBeVisible()
      })
    })
  })
}
