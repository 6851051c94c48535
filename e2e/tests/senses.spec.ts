// Rooms: senses, learning, lab
import { TryHands } from '../child-trying.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`what Bo learns with its own sensors, in ${language}`, () => {
    test.use({ language })

    test('card NN 24 opens with it, and says before trying why nothing can be learned', async ({ child }) => {
      const bo = new TryHands(child)
      await child.opensLab('try-dodge')
      await bo.sees()
      await expect(child.words('problem.tryNoPay.text')).toBeVisible()
      await expect(child.words('senses.sizeBump', { product: '3 × 3', states: 10 })).toBeVisible()
      await expect(bo.table.locator('tbody tr')).toHaveCount(10)
      await expect.poll(() => bo.untried()).toBe(30)
      await expect(child.page.locator('.size')).toContainText(child.word('senses.notYet', { count: 30 }))
    })

    test('the table fills while Bo tries; a cell is tapped, its number proved, and time goes back to the table of then', async ({
      child,
    }) => {
      const bo = new TryHands(child)
      await bo.opensSolution()
      await child.pressesStart()
      await bo.time.opens()
      await bo.time.chooses('16')
      await bo.time.runsUntil(20)
      const [numbers, untried] = [await bo.numbers(), await bo.untried()]
      expect(untried).toBeLessThan(30)
      await expect(child.page.locator('.size')).toContainText(child.word('senses.notYet', { count: untried }))
      await expect(bo.table.locator('tr[aria-current]')).toHaveCount(1)
      await expect(bo.lens).toContainText('× (')
      const tried = numbers.findIndex((text) => text.trim() !== '·')
      await bo.cell(Math.floor(tried / 3), tried % 3).click()
      await bo.proof.asks()
      const { number } = await bo.proof.saves()
      expect(number.toFixed(1)).toBe(numbers[tried]!.replace('−', '-').replace(',', '.'))
      await bo.proof.closes()
      await bo.time.goesBack('Home')
      await expect.poll(() => bo.untried()).toBe(30)
      await child.presses('time.toNow')
      await expect.poll(() => bo.numbers()).toEqual(numbers)
    })

    test('edges are typed, and pushed along the rays by keys; each is a step to undo', async ({ child }) => {
      const bo = new TryHands(child)
      await bo.opensSolution()
      await child.presses('senses.edges')
      await bo.typedEdge('left', 'nearBelow').fill('22')
      await child.types('Enter')
      await expect(bo.edgeOnRay('left', 'nearBelow')).toHaveAttribute('aria-valuenow', '22')
      await bo.typedEdge('left', 'nearBelow').fill('much')
      await child.types('Enter')
      await expect(bo.typedEdge('left', 'nearBelow')).toHaveValue('22')
      await bo.edgeOnRay('right', 'farFrom').focus()
      await child.types('PageUp')
      await expect(bo.typedEdge('right', 'farFrom')).toHaveValue('50')
      await child.presses('lab.undo')
      await expect(bo.typedEdge('right', 'farFrom')).toHaveValue('40')
      await child.presses('lab.undo')
      await expect(bo.typedEdge('left', 'nearBelow')).toHaveValue('15')
    })
  })
