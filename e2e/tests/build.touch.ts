// Rooms: world
import { Builder } from '../child-build.ts'
import { pinch } from '../hand.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}, with a finger`, () => {
    test.use({ language })

    test('builds: the world fills the lab, a thing is put down, moved and pulled bigger, and the lab comes back', async ({
      child,
    }) => {
      const builder = new Builder(child)
      await child.opensLab('free')
      // Without a network the world is as large as it can be; beside one it has to grow.
      await child.presses('lab.unfoldNetwork')
      await expect(child.words('network.empty')).toBeVisible()
      const before = (await builder.world.boundingBox())!.height
      await builder.begins()
      await expect.poll(async () => (await builder.world.boundingBox())!.height).toBeGreaterThan(before * 1.5)

      await builder.addsThing('rectangle')
      const box = builder.all('world.thing.rectangle')
      const [at, spot] = [await builder.placeOf(box), await child.middleOf(box)]
      await child.drags(spot, { x: spot.x - 90, y: spot.y })
      await expect.poll(async () => (await builder.placeOf(box)).x).toBeLessThan(at.x - 20)
      const handle = await child.middleOf(
        child.button('build.size', { thing: child.word('world.thing.rectangle') }),
      )
      const width = (await box.boundingBox())!.width
      await child.drags(handle, { x: handle.x + 40, y: handle.y + 40 })
      await expect.poll(async () => (await box.boundingBox())!.width).toBeGreaterThan(width + 20)
      await builder.ends()
      await expect.poll(async () => (await builder.world.boundingBox())!.height).toBeCloseTo(before, 0)
    })

    test('brings the floor nearer with two fingers', async ({ child, page }) => {
      await child.opensLab('free')
      const { world } = new Builder(child)
      const width = () => child.painted.wheelsApart()
      const before = await width()
      await pinch(page, await child.middleOf(world), 80, 200)
      await expect.poll(width).toBeGreaterThan(before * 1.5)
      await pinch(page, await child.middleOf(world), 200, 80)
      await expect.poll(width).toBeLessThan(before * 1.2)
    })
  })
}
