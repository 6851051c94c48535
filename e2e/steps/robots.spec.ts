import { TimeHands } from '../child-time.ts'
import { leftEye, leftWheel } from '../child.ts'
import { opensCard, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

test('several robots, step by step', { tag: '@robots' }, async ({ child }) => {
  const robots = new TimeHands(child)
  const dialog = child.dialog('robots.addTitle')
  await goesThrough(child, 'robots', {
    'which robot': async () => {
      await opensCard(child, 'friendship')
      await robots.asks()
    },
    'none after all': () =>
      dialog
        .getByRole('button', { name: child.word('parts.close'), exact: true })
        .last()
        .click(),
    'one beside it, with the weights of the next card': async () => {
      await robots.asks()
      await child.presses('robots.beside', { card: child.card('fear') })
    },
    'the first robot': () => robots.chip(1).click(),
    'a weight of its own': () => child.typesWeight(leftEye, leftWheel, 0.8),
    'which robot, once more': () => robots.asks(),
    'none, by keys': () => child.types('Escape'),
    'one of the same program': async () => {
      await robots.asks()
      await child.presses('robots.shared')
    },
    'one of its own program': async () => {
      await robots.asks()
      await child.presses('robots.own')
    },
    'it goes': () => child.presses('robots.remove', { name: robots.robotName(4) }),
  })
})
