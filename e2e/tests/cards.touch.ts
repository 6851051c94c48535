// Rooms: content, network
import { leftEye, leftWheel, rightEye, rightWheel, type Sensor } from '../child.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const light: Sensor = { sensor: 'light', port: '1', place: 'front' }

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language} and has nothing but a finger`, () => {
    test.use({ language })

    test('lets the Bo of Friendship drive beside the one of Fear', async ({ child, page }) => {
      const robots = new TimeHands(child)
      await child.opensLab('fear')
      await child.dragsKnob(leftEye, rightWheel, 0.8)
      await child.dragsKnob(rightEye, leftWheel, 0.8)
      await child.button('lab.card').tap()
      await child.button('robots.beside', { card: child.card('friendship') }).tap()
      await expect(robots.row.getByRole('button', { pressed: true })).toContainText(child.card('friendship'))
      await child.seesWeight(leftEye, leftWheel, 0.8)
      await expect(
        page.getByText(child.word('robots.differ', { name: child.word('world.robot'), count: 4, of: 4 })),
      ).toBeVisible()
      await robots.chip(1).tap()
      await child.seesWeight(leftEye, rightWheel, 0.8)
      await child.button('lab.start').first().tap()
      await new TimeHands(child).hurries()
      await child.seesCheck('fear', 'turnsAway')
    })

    test('solves Incognito: a second wheel by the plus, two knobs, and Bo stands in the shade', async ({
      child,
      page,
    }) => {
      await child.opensLab('incognito')
      await child.plus('addMotor').tap()
      await child.offered.first().tap()
      await expect(child.knobs).toHaveCount(2)
      await child.dragsKnob(light, leftWheel, 0.6)
      await child.dragsKnob(light, rightWheel, 0.6)
      await child.button('lab.start').first().tap()
      await new TimeHands(child).hurries()
      await child.seesCheck('incognito', 'rests', true, 60_000)
      await expect(page.getByText(child.word('lab.successTitle')).first()).toBeVisible()
    })
  })
}
