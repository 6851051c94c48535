// Rooms: lab, home, words
import { leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language, serviceWorkers: 'allow', motion: true })

    test('goes from home to a robot that finds friends, comes back, and gives the same blocks other weights', async ({
      child,
    }) => {
      test.setTimeout(240_000)

      await test.step('home, Friendship, start and pause, two knobs, on', async () => {
        await child.opensHome()
        await child.opensLab('friendship')
        await child.pressesStart()
        await child.presses('lab.pause')
        await child.dragsKnob(leftEye, leftWheel, 0.8)
        await child.dragsKnob(rightEye, rightWheel, 0.8)
        await child.seesStanding()
        await child.presses('lab.continue')
        await child.seesDriving()
      })

      await test.step('Bo arrives, and all goals are green', async () => {
        for (const goal of ['near', 'neverTouches', 'stays']) await child.seesCheck('friendship', goal)
        await expect(child.page.getByText(child.word('lab.successTitle'))).toBeVisible()
        await expect(child.button('lab.placePassed', { number: 1 })).toBeVisible()
        await child.seesSaved()
      })

      const words = await child.blockWords()
      await test.step('after a reload weights, program and progress are there', async () => {
        await child.reloads()
        await child.seesWeight(leftEye, leftWheel, 0.8)
        await child.seesWeight(leftEye, rightWheel, 0)
        await child.seesWeight(rightEye, leftWheel, 0)
        await child.seesWeight(rightEye, rightWheel, 0.8)
        await expect.poll(() => child.blockWords()).toEqual(words)
        await expect(child.button('lab.placePassed', { number: 1 })).toBeVisible()
      })

      await test.step('home shows how far the child has come, and leads on', async () => {
        await child.page.getByRole('link', { name: child.word('parts.home') }).click()
        await expect(
          child.page.getByRole('img', { name: child.word('home.level', { passed: 1, of: 3 }) }),
        ).toBeVisible()
        await child.opensLab('fear')
      })

      await test.step('Fear: the same blocks, other weights', async () => {
        await expect.poll(() => child.blockWords()).toEqual(words)
        await child.dragsKnob(leftEye, rightWheel, 0.8)
        await child.dragsKnob(rightEye, leftWheel, 0.8)
        await child.pressesStart()
        await new TimeHands(child).hurries()
        for (const goal of ['near', 'turnsAway', 'neverTouches']) await child.seesCheck('fear', goal)
        await expect(child.button('lab.placePassed', { number: 1 })).toBeVisible()
      })
    })
  })
}
