// Rooms: network
import { expect, test } from '../house.ts'
import { bigNet } from '../projects.ts'

for (const { name, size } of [
  { name: 'a laptop', size: { width: 1366, height: 768 } },
  { name: 'a phone', size: { width: 390, height: 844 } },
])
  test.describe(`on ${name}`, () => {
    test.use({ viewport: size })

    test('a net of eight sensors and six outputs is drawn, can be set knob by knob, and drives', async ({
      child,
    }) => {
      const phone = size.width < 640
      await child.opensProjectAtHome('Big', bigNet('Big'))
      if (phone) await child.turnsTo('networkTab')
      await expect(child.knobs).toHaveCount(48)

      await test.step('every knob can be seen, stands free of the others, and takes a number', async () => {
        for (const index of [0, 5, 23, 24, 42, 47]) {
          const knob = child.knobs.nth(index)
          await knob.scrollIntoViewIfNeeded()
          await expect(knob).toBeInViewport()
          await knob.focus()
          await child.types('End')
          await expect(knob).toHaveAttribute('aria-valuenow', '1')
        }
      })

      await test.step('what a finger takes hold of is the knob it means', async () => {
        for (const index of [0, 5, 24, 47]) {
          const knob = child.knobs.nth(index)
          await knob.scrollIntoViewIfNeeded()
          const at = await child.middleOf(knob)
          await child.drags(at, { x: at.x - 60, y: at.y })
          await expect(knob).not.toHaveAttribute('aria-valuenow', '1')
        }
      })

      await test.step('nodes are no smaller than a finger', async () => {
        const sums = child.page.getByRole('button', {
          name: new RegExp(child.word('network.showSum', { output: '.+' })),
        })
        await expect(sums).toHaveCount(6)
        for (const node of await sums.all())
          await expect.poll(async () => (await node.boundingBox())!.width).toBeGreaterThanOrEqual(44)
      })

      await child.pressesStart()
      if (phone) await child.turnsTo('world')
      await child.seesDriving()
    })
  })
