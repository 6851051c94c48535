// Rooms: robot, storage
import { leftEye, leftWheel, rightWheel } from '../child.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`several robots, in ${language}`, () => {
    test.use({ language })

    test('two run the same program with weights of their own, and undo takes the second away', async ({
      child,
    }) => {
      const robots = new TimeHands(child)
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await child.typesWeight(leftEye, rightWheel, 0.3)
      await robots.adds('shared')
      await expect(robots.chip(2)).toHaveAttribute('aria-pressed', 'true')
      await child.seesWeight(leftEye, leftWheel, 0.5)
      await child.typesWeight(leftEye, leftWheel, 0)
      await child.typesWeight(leftEye, rightWheel, 0)
      await robots.chip(1).click()
      await child.seesWeight(leftEye, leftWheel, 0.5)

      const [first, second] = [await robots.stands(1), await robots.stands(2)]
      await child.pressesStart()
      await expect.poll(() => robots.stands(1)).not.toBe(first)
      await expect.poll(() => robots.stands(2)).toBe(second)
      await child.pressesStop()

      for (let back = 0; back < 2; back += 1) await child.presses('lab.undo')
      await robots.chip(2).click()
      await child.seesWeight(leftEye, leftWheel, 0.5)
      await child.presses('lab.undo')
      await expect(robots.robot(2)).toHaveCount(0)
      await expect(robots.row).toHaveCount(0)
      await child.presses('lab.redo')
      await expect(robots.robot(2)).toBeVisible()
    })

    test('one with a program of its own: its blocks change alone, undo goes to where they are', async ({
      child,
    }) => {
      const robots = new TimeHands(child)
      await child.opensLab('friendship')
      await robots.adds('own')
      await expect(child.canvas.locator('[data-id^="bo2-"]').first()).toBeVisible()
      await expect(child.knobs).toHaveCount(4)
      await child.addsNeuron('addMotor')
      await expect(child.knobs).toHaveCount(6)
      await robots.chip(1).click()
      await expect(child.knobs).toHaveCount(4)
      await child.presses('lab.undo')
      await expect(robots.chip(2)).toHaveAttribute('aria-pressed', 'true')
      await expect(child.knobs).toHaveCount(4)
    })
  })
}
