// Rooms: network
import { leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language, motion: true })

    test('teaches Bo friendship with a finger, and finds all again after a reload', async ({ child }) => {
      await child.opensHome()
      await child.opensLab('friendship')
      await child.dragsKnob(leftEye, leftWheel, 0.8)
      await child.dragsKnob(rightEye, rightWheel, 0.8)
      await child.pressesStart()
      await child.seesDriving()
      await child.seesSaved()
      await child.reloads()
      await child.seesWeight(leftEye, leftWheel, 0.8)
      await child.seesWeight(rightEye, rightWheel, 0.8)
    })
  })
}
