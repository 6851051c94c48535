// Rooms: app
import { Asker } from '../child-inside.ts'
import { leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { NetHands } from '../child-network.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { emptyNet } from '../projects.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language })

    test('asks why a hidden neuron gets what it gets, and how it depends', async ({ child }) => {
      const net = new NetHands(child)
      const asker = new Asker(child)
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await net.chooses('explorer')
      await child.presses('net.addLayer')
      await net.neuron(1, 1).click()
      await asker.asksWhy()
      const name = child.word('net.hidden', { layer: 1, neuron: 1 })
      await expect(asker.panel.getByRole('heading')).toContainText(name)
      await asker.seesSharesAddUp()
      await child.presses('inside.curve')
      await expect(asker.panel.getByRole('heading')).toHaveText(
        child.word('inside.howDepends', { output: name }),
      )
      await expect(asker.panel.getByRole('img')).toHaveCount(2)
      await asker.asksAbout(leftWheel)
      await expect(asker.panel.getByRole('heading')).not.toContainText(name)
      await expect(asker.panel.getByRole('img')).toHaveCount(2)
    })

    test('asks a network without sensors, and one without motors', async ({ child }) => {
      const asker = new Asker(child)
      await child.opensProjectAtHome('Nothing', emptyNet('Nothing', '3', []))
      await asker.asksWhy()
      await expect(asker.panel).toContainText(child.word('inside.noInputs'))
      await child.presses('inside.curve')
      await expect(asker.panel).toContainText(child.word('inside.noInputs'))
    })

    test('counts knobs from 0 to 10', async ({ child }) => {
      const net = new NetHands(child)
      await child.opensLab('friendship')
      await net.opensSettings()
      await child.page.getByRole('switch', { name: child.word('lab.tens') }).check({ force: true })
      await child.types('Escape')
      await child.knob(leftEye, leftWheel).focus()
      await child.types('8', 'Enter')
      await child.seesWeight(leftEye, leftWheel, 0.8)
      await expect(child.knob(leftEye, leftWheel)).toHaveAttribute('aria-valuetext', '8')
      await child.types('ArrowDown')
      await child.seesWeight(leftEye, leftWheel, 0.7)
    })

    test('gives a brain from the shelf to another robot', async ({ child }) => {
      const net = new NetHands(child)
      const robots = new TimeHands(child)
      await child.opensLab('friendship')
      await child.typesWeight(rightEye, rightWheel, 0.75)
      await child.presses('lab.card')
      await child.presses('robots.beside', { card: child.card('fear') })
      await robots.chip(1).click()
      await child.seesWeight(rightEye, rightWheel, 0.75)
      await net.opensShelf()
      await net.putsOnShelf('steady')
      const other = child.word('robots.name', { number: 2 })
      await child.presses('net.give', { robot: other })
      await net.isTold('net.given', { robot: other, name: 'steady' })
      await child.types('Escape')
      await robots.row.getByRole('button', { name: other }).click()
      await child.seesWeight(rightEye, rightWheel, 0.75)
    })

    test('sees what Bo would do everywhere change while a knob is pulled', async ({ child, page }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.6)
      const drawing = () => child.painted.drawing(page.locator('.world > canvas'))
      const bare = await drawing()
      await child.presses('lab.worldSettings')
      await page.getByRole('switch', { name: child.word('inside.field') }).setChecked(true, { force: true })
      await child.types('Escape')
      await expect(page.getByRole('img', { name: child.word('inside.fieldPicture') })).toBeAttached()
      await expect.poll(drawing).not.toBe(bare)
      const before = await drawing()
      const knob = await child.middleOf(child.knob(leftEye, rightWheel))
      await page.mouse.move(knob.x, knob.y)
      await page.mouse.down()
      await page.mouse.move(knob.x + 60, knob.y + 40, { steps: 4 })
      await expect.poll(drawing).not.toBe(before)
      await page.mouse.up()
    })
  })
