import { opensSettings } from '../child-cards.ts'
import { opensCard, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en', newcomer: true })

test('the tour, step by step', { tag: '@tour' }, async ({ child, page }) => {
  const again = async () => {
    await opensSettings(child, 'lab')
    await child.presses('tour.again')
  }
  const region = page.getByRole('region', { name: child.word('tour.title'), exact: true })
  await goesThrough(child, 'tour', {
    'the tour is offered': async () => {
      await opensCard(child, 'friendship')
      await region.waitFor()
    },
    'no, thank you': () => child.presses('tour.no'),
    'the first step, from the settings': again,
    'it is closed': () =>
      region.getByRole('button', { name: child.word('parts.close'), exact: true }).click(),
    'the first step again': again,
    'the block lights up': () => child.presses('tour.show'),
    'the second step': () => child.presses('tour.next'),
    'the node lights up': () => child.presses('tour.show'),
    'the third step': () => child.presses('tour.next'),
    'the wheel lights up': () => child.presses('tour.show'),
    'the end': () => child.presses('tour.done'),
  })
})

test('the tour on a phone, step by step', { tag: '@tour' }, async ({ child, page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await goesThrough(child, 'tour-phone', {
    'the first step': async () => {
      await opensCard(child, 'friendship')
      await child.presses('tour.yes')
    },
    'the block lights up': () => child.presses('tour.show'),
    'the second step': () => child.presses('tour.next'),
    'the node lights up': () => child.presses('tour.show'),
    'the third step': () => child.presses('tour.next'),
    'the wheel lights up': () => child.presses('tour.show'),
    'the end': () => child.presses('tour.done'),
  })
})
