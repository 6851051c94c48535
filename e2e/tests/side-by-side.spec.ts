// Rooms: robots
import { leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`Fear and Friendship side by side, in ${language}`, () => {
    test.use({ language })

    test('one click on the card brings the other Bo; links that differ are marked, and what they do differs', async ({
      child,
      page,
    }) => {
      const robots = new TimeHands(child)
      await child.opensLab('fear')
      await child.typesWeight(leftEye, rightWheel, 0.8)
      await child.typesWeight(rightEye, leftWheel, 0.8)
      await child.presses('lab.card')
      await child.presses('robots.beside', { card: child.card('friendship') })
      await expect(robots.row.getByRole('button', { pressed: true })).toContainText(child.card('friendship'))
      await child.seesWeight(leftEye, leftWheel, 0.8)
      const first = child.word('world.robot')
      await expect(
        page.getByText(child.word('robots.differ', { name: first, count: 4, of: 4 })),
      ).toBeVisible()
      await expect(child.knob(leftEye, leftWheel)).toHaveAccessibleDescription(
        child.word('robots.differs', { name: first, weight: '0' }),
      )

      await robots.chip(1).focus()
      await child.types('Enter')
      await child.seesWeight(leftEye, rightWheel, 0.8)
      await child.pressesStart()
      await robots.hurries()
      await child.seesCheck('fear', 'turnsAway')
      await child.seesCheck('fear', 'neverTouches')
      await child.pressesStop()
      await child.presses('lab.undo')
      await expect(robots.row).toHaveCount(0)
    })
  })
}
