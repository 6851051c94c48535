import { expect, test } from '../house.ts'

test('slides are turned by drawing a finger across, and not by moving it down', async ({ child, page }) => {
  await page.goto('/materials/slides/can-robots-learn-alone?slide=3')
  const at = (number: number) => page.getByText(child.word('materials.slideOf', { number, of: 15 }))
  await expect(at(3)).toBeVisible()
  await child.drags({ x: 600, y: 300 }, { x: 300, y: 320 })
  await expect(at(4)).toBeVisible()
  await child.drags({ x: 300, y: 300 }, { x: 600, y: 280 })
  await child.drags({ x: 300, y: 300 }, { x: 600, y: 280 })
  await expect(at(2)).toBeVisible()
})
