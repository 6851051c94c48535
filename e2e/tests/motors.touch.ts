// Rooms: robot
import { RobotHands } from '../child-robot.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`Bo's motors by a finger, in ${language}`, () => {
    test.use({ language })

    test('a tap shows what a motor can do, every choice is big enough, and what is chosen stays', async ({
      child,
    }) => {
      const bo = new RobotHands(child)
      await child.opensLab('free')
      await bo.opens('build')
      const motor = bo.motor('A').getByRole('button')
      await motor.tap()
      await expect(motor).toHaveAttribute('aria-pressed', 'true')
      await bo.setting('plugged').selectOption({ label: bo.word('plug.motor_big') })
      await bo.setting('turns').selectOption({ label: bo.word('backwards') })
      await bo.setting('power').selectOption({ label: bo.word('unregulated') })
      await bo.dialog.getByRole('button', { name: child.word('lab.undo') }).tap()
      await expect(bo.setting('power').locator('option:checked')).toHaveText(bo.word('regulated'))
      await bo.setting('power').selectOption({ label: bo.word('unregulated') })
      for (const target of [motor, ...(['plugged', 'wheel', 'turns', 'power'] as const).map(bo.setting)]) {
        const { width, height } = (await target.boundingBox())!
        expect(Math.min(width, height)).toBeGreaterThanOrEqual(44)
      }
      await bo.motor('B').getByRole('button').tap()
      await expect(bo.setting('plugged')).toHaveCount(0)
      await expect(bo.setting('turns').locator('option:checked')).toHaveText(bo.word('forwards'))

      await bo.dialog.getByRole('button', { name: child.word('parts.close'), exact: true }).tap()
      await child.seesSaved()
      await child.reloads()
      await bo.opens('build')
      await motor.tap()
      const chosen = {
        plugged: 'plug.motor_big',
        wheel: 'noWheel',
        turns: 'backwards',
        power: 'unregulated',
      } as const
      for (const [setting, word] of Object.entries(chosen))
        await expect(bo.setting(setting as keyof typeof chosen).locator('option:checked')).toHaveText(
          bo.word(word),
        )
    })
  })
}
