// Rooms: network
import { NetHands } from '../child-network.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language })

    test('builds a hidden layer with a finger, and turns one of its knobs below zero', async ({ child }) => {
      const net = new NetHands(child)
      await child.opensLab('friendship')
      await net.chooses('explorer')
      await child.presses('net.addLayer')
      await expect(net.layer(1)).toBeVisible()
      const knob = child.knobs.first()
      await knob.scrollIntoViewIfNeeded()
      const at = await child.middleOf(knob)
      await child.drags(at, { x: at.x - 40, y: at.y })
      await expect.poll(async () => Number(await knob.getAttribute('aria-valuenow'))).toBeLessThan(0)
    })
  })
