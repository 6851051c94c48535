import { Asker } from '../child-inside.ts'
import { leftEye, leftWheel, rightWheel } from '../child.ts'
import { expect, opensCard, test } from './gate.ts'

test.use({ language: 'en' })

test(
  '“Why?” adds up to the motor, shows what one weight would change, a function, and the field',
  {
    tag: '@inside',
  },
  async ({ child, page }) => {
    const asker = new Asker(child)
    await opensCard(child, 'friendship')
    await child.typesWeight(leftEye, leftWheel, 0.6)
    await child.typesWeight(leftEye, rightWheel, 0.25)
    await child.pressesStart()
    await child.seesDriving()
    await asker.asksWhy()
    await asker.seesSharesAddUp()
    const before = await asker.shares()
    await asker.asksAbout(rightWheel)
    await expect(asker.panel.getByRole('heading')).toContainText('B')
    await child.typesWeight(leftEye, rightWheel, 0.5)
    await expect.poll(() => asker.shares()).not.toEqual(before)
    await asker.seesSharesAddUp()

    const without = child.word('network.place.frontLeft')
    await asker.eye('frontLeft').click()
    await expect(asker.pale('inside.without', { input: without })).toBeVisible()
    await asker.eye('frontLeft').click()
    await asker.change.click()
    const after = await asker.change.locator('i').last().textContent()
    await expect(asker.pale('inside.with', { weight: after! })).toBeVisible()

    await child.presses('inside.curve')
    await expect(asker.panel.getByRole('img')).toHaveCount(2)
    const motor = child.word('neuron.motor', { OUTPUTNODE: 'B' })
    await expect(asker.panel.getByRole('img').first()).toHaveAccessibleName(new RegExp(motor))
    await child.presses('inside.close')
    await expect(asker.panel).toHaveCount(0)

    const drawing = () => child.painted.drawing(page.locator('.world > canvas'))
    await child.presses('lab.worldSettings')
    await page.getByRole('switch', { name: child.word('inside.field') }).check({ force: true })
    await child.types('Escape')
    await expect(page.getByRole('img', { name: child.word('inside.fieldPicture') })).toHaveCount(1)
    const field = await drawing()
    await child.typesWeight(leftEye, leftWheel, 0)
    await expect.poll(drawing).not.toBe(field)
  },
)
