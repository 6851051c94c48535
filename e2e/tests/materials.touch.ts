// Rooms: materials
// By address: codes on paper and links of a plan lead to a page of its own.
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'

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

test('where nothing fits beside the library, what is looked at lies over it and leads on', async ({
  child,
  page,
}) => {
  await opensFromHome(child, 'home.materials')
  const name = child.card('city')
  const look = child.button('materials.look', { title: name })
  await look.tap()
  const over = page.getByRole('dialog', { name })
  await expect(over.locator('.material[aria-busy="false"]')).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(over).toBeHidden()
  await expect(look).toBeFocused()
  await look.tap()
  await over.getByRole('link', { name: child.word('materials.open'), exact: true }).tap()
  await expect(page.getByRole('heading', { level: 1 })).toHaveText(name)
})
