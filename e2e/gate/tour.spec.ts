import { node } from '../child-cards.ts'
import { leftWheel } from '../child.ts'
import { expect, opensCard, test } from './gate.ts'

test.use({ language: 'de', newcomer: true })

test(
  'the tour goes through block, neuron and wheel, each lights up with the others, and is offered once',
  {
    tag: '@tour',
  },
  async ({ child, page }) => {
    const motor = child.word('neuron.motor', { OUTPUTNODE: leftWheel.motor })
    const tour = page.getByRole('region', { name: child.word('tour.title'), exact: true })
    await opensCard(child, 'friendship')
    await expect(tour).toContainText(child.word('tour.offer'))
    await child.presses('tour.yes')
    await expect(tour).toContainText(child.word('tour.block', { name: motor }))
    const block = child.block('wheelLeft').locator('.blocklyPath').first()
    await block.click({ position: { x: 8, y: 14 } })
    await expect(tour).toContainText(child.word('tour.litBlock'))
    await expect.poll(() => child.painted.lit()).toContain('neuron wheelLeft')
    await child.presses('tour.next')
    await node(child, 'showSum', motor).click()
    await expect(tour).toContainText(child.word('tour.litNode'))
    await child.presses('tour.next')
    const { x, y } = await child.painted.place('bo motor C')
    await page.mouse.click(x, y)
    await expect(tour).toContainText(child.word('tour.litWheel'))
    await child.presses('tour.done')
    await expect(tour).toHaveCount(0)
    await child.reloads()
    await expect(tour).toHaveCount(0)
    await child.presses('lab.menu')
    await child.presses('comfort.title')
    await child.presses('tour.again')
    await expect(tour).toContainText(child.word('tour.step', { number: 1, of: 3 }))
  },
)
