// Rooms: robot, storage
import { leftEye, leftWheel, rightWheel } from '../child.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`several robots, in ${language}`, () => {
    test.use({ language })

    test('two run the same program with weights of their own, and undo takes the second away', async ({
      child,
    }) => {
      const crew = new TimeHands(child)
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await child.typesWeight(leftEye, rightWheel, 0.3)
      await crew.adds('shared')
      await expect(crew.chip(2)).toHaveAttribute('aria-pressed', 'true')
      await child.seesWeight(leftEye, leftWheel, 0.5)
      await child.typesWeight(leftEye, leftWheel, 0)
      await child.typesWeight(leftEye, rightWheel, 0)
      await crew.chip(1).click()
      await child.seesWeight(leftEye, leftWheel, 0.5)

      const [first, second] = [await crew.stands(1), await crew.stands(2)]
      await child.pressesStart()
      await expect.poll(() => crew.stands(1)).not.toBe(first)
      expect(await crew.stands(2)).toBe(second)
      await child.pressesStop()

      for (let back = 0; back < 2; back += 1) await child.presses('lab.undo')
      await crew.chip(2).click()
      await child.seesWeight(leftEye, leftWheel, 0.5)
      await child.presses('lab.undo')
      await expect(crew.robot(2)).toHaveCount(0)
      await expect(crew.row).toHaveCount(0)
      await child.presses('lab.redo')
      await expect(crew.robot(2)).toBeVisible()
    })

    test('one with a program of its own: its blocks change alone, undo goes to where they are', async ({
      child,
    }) => {
      const crew = new TimeHands(child)
      await child.opensLab('friendship')
      await crew.adds('own')
      await expect(child.canvas.locator('[data-id^="bo2-"]').first()).toBeVisible()
      await expect(child.knobs).toHaveCount(4)
      await child.presses('network.addMotor')
      await expect(child.knobs).toHaveCount(6)
      await crew.chip(1).click()
      await expect(child.knobs).toHaveCount(4)
      await child.presses('lab.undo')
      await expect(crew.chip(2)).toHaveAttribute('aria-pressed', 'true')
      await expect(child.knobs).toHaveCount(4)
    })

    test('four at most; they are kept over a reload and in a file; each but the first can go', async ({
      child,
    }) => {
      const crew = new TimeHands(child)
      await child.opensLab('free')
      for (const kind of ['shared', 'own', 'shared'] as const) await crew.adds(kind)
      await expect(crew.chip(4)).toBeVisible()
      await expect(crew.row.getByRole('button', { name: child.word('robots.add') })).toHaveAttribute(
        'aria-disabled',
        'true',
      )
      await child.seesSaved()
      const file = JSON.parse(await child.savesFile()) as {
        world: { robots: { program: string; brain: string }[] }
      }
      expect(file.world.robots.map(({ program, brain }) => [program, brain])).toEqual([
        ['main', ''],
        ['main', 'bo2'],
        ['bo3', ''],
        ['bo3', 'bo4'],
      ])
      await child.page.reload()
      await child.seesLab()
      await expect(crew.robot(4)).toBeVisible()
      await crew.chip(3).click()
      await child.presses('robots.remove', { name: crew.robotName(3) })
      await expect(crew.robot(4)).toHaveCount(0)
      await crew.chip(1).click()
      await expect(child.button('robots.remove', { name: crew.robotName(1) })).toHaveAttribute(
        'aria-disabled',
        'true',
      )
    })
  })
}
