// Rooms: inside
import { Asker } from '../child-inside.ts'
import { TimeHands } from '../child-time.ts'
import { leftEye, leftWheel, rightWheel } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language })

    test('asks why after a crash, at the moment before it, and what would be without the left eye', async ({
      child,
    }) => {
      const asker = new Asker(child)
      await asker.crashes()
      await asker.asksWhy()
      await asker.seesSharesAddUp()
      const after = await asker.shares()
      const time = new TimeHands(child)
      await time.opens()
      await time.goesBack('PageDown', ...Array.from({ length: 12 }, () => 'ArrowRight'))
      await expect.poll(() => asker.shares()).not.toEqual(after)
      await asker.seesSharesAddUp()
      const without = child.word('network.place.frontLeft')
      await asker.eye('frontLeft').click()
      await expect(asker.eye('frontLeft')).toHaveAttribute('aria-pressed', 'true')
      await expect(asker.pale('inside.without', { input: without })).toBeVisible()
      await expect(asker.panel).toContainText(child.word('inside.paleWithout', { input: without }))
      await asker.eye('frontLeft').click()
      await expect(asker.pale('inside.without', { input: without })).toHaveCount(0)
      await child.presses('inside.close')
      await expect(asker.panel).toHaveCount(0)
      await expect(child.button('network.why')).toBeVisible()
    })

    test('sees the smallest change that turns Bo round, and a pale Bo that drives with it, by keys alone', async ({
      child,
    }) => {
      const asker = new Asker(child)
      await asker.asksOnTheWay()
      await child.tabsTo(asker.change)
      await expect(asker.change).toContainText(child.word('inside.turnsLeft'))
      await child.types('Enter')
      await expect(asker.change).toHaveAttribute('aria-pressed', 'true')
      const after = await asker.change.locator('i').last().textContent()
      await expect(asker.pale('inside.with', { weight: after! })).toBeVisible()
      await child.types('Escape')
      await expect(asker.panel).toHaveCount(0)
      // Escape in the question puts it away and does not stop Bo.
      await expect(child.button('lab.continue').first()).toBeVisible()
    })

    test('turning to another motor and pulling a knob is answered at once', async ({ child }) => {
      const asker = new Asker(child)
      await asker.asksOnTheWay()
      await asker.asksAbout(rightWheel)
      await expect(asker.panel.getByRole('heading')).toContainText('B')
      const before = await asker.shares()
      await child.typesWeight(leftEye, rightWheel, 0.75)
      await expect.poll(() => asker.shares()).not.toEqual(before)
      await asker.seesSharesAddUp()
    })

    test('sees the function of a link, and of two inputs', async ({ child }) => {
      const asker = new Asker(child)
      await asker.asksOnTheWay()
      await child.presses('inside.curve')
      const pictures = asker.panel.getByRole('img')
      await expect(pictures).toHaveCount(2)
      const left = child.word('network.place.frontLeft')
      await child.knob(leftEye, leftWheel).focus()
      const motor = child.word('neuron.motor', { OUTPUTNODE: 'C' })
      const rises = child.word('inside.rises', { from: left, to: motor, now: '\\d+', value: '\\d+' })
      await expect(pictures.first()).toHaveAccessibleName(new RegExp(`^${rises}$`))
      await asker.panel
        .getByRole('combobox')
        .first()
        .selectOption({ label: child.word('network.place.frontRight') })
      await expect(pictures.first()).not.toHaveAccessibleName(new RegExp(`^${rises}$`))
    })

    test('sees what Bo would do all over the floor, and turns it off again', async ({ child, page }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.6)
      const picture = page.getByRole('img', { name: child.word('inside.fieldPicture') })
      const show = page.getByRole('switch', { name: child.word('inside.field') })
      await child.presses('lab.worldSettings')
      await show.setChecked(true, { force: true })
      await child.types('Escape')
      await expect(picture).toHaveCount(1)
      await child.presses('lab.worldSettings')
      await show.setChecked(false, { force: true })
      await expect(picture).toHaveCount(0)
    })

    test('asks before the first start, before the start of time, and while blocks are changed', async ({
      child,
    }) => {
      const asker = new Asker(child)
      await child.opensLab('friendship')
      await asker.asksWhy()
      await expect(asker.panel).toContainText(child.word('inside.bringsNothing'))
      await child.pressesStart()
      await child.seesBlocks()
      const time = new TimeHands(child)
      await time.opens()
      await time.runsUntil(1)
      await time.goesBack('Home', 'ArrowLeft')
      await asker.seesAnswer()
      await asker.seesSharesAddUp()
      // A motor more: the answer follows the program.
      await child.presses('inside.close')
      await child.addsNeuron('addMotor')
      await asker.asksWhy()
      await asker.seesSharesAddUp()
    })
  })
}
