import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { Asker } from '../child-inside.ts'
import { NetHands } from '../child-network.ts'
import { expect, opensCard, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

const press = (key: string) => (child: Child) => child.presses(key)

test('questions to a network, step by step', { tag: '@inside' }, async ({ child, page }) => {
  const asker = new Asker(child)
  const net = new NetHands(child)
  const list = (key: string) => page.getByRole('combobox', { name: child.word(key), exact: true })
  const field = page.getByRole('switch', { name: child.word('inside.field') })
  await goesThrough(child, 'inside', {
    'a network with weights': async () => {
      await opensCard(child, 'friendship')
      await child.typesWeight(leftEye, leftWheel, 0.6)
      await child.typesWeight(leftEye, rightWheel, 0.25)
    },
    why: () => asker.asksWhy(),
    'another motor': () => asker.asksAbout(leftWheel),
    'an eye is left out': () => asker.eye('frontLeft').click(),
    'it is taken in again': () => asker.eye('frontLeft').click(),
    'the smallest change': () => asker.change.click(),
    'without it': () => asker.change.click(),
    'no weight brings anything': async () => {
      await child.typesWeight(leftEye, rightWheel, 0)
      await expect(asker.panel).toContainText(child.word('inside.bringsNothing'))
    },
    'full speed': async () => {
      await child.typesWeight(leftEye, rightWheel, 0.9)
      await child.typesWeight(rightEye, rightWheel, 0.5)
    },
    'the function': press('inside.curve'),
    'across the other eye': () => list('inside.across').selectOption({ index: 0 }),
    'a link is touched': () => child.knob(rightEye, rightWheel).focus(),
    'why again': press('network.why'),
    'it is put away by key': () => asker.panel.press('Escape'),
    'a deeper network with a bias is asked': async () => {
      await net.chooses('explorer')
      await child.presses('net.addLayer')
      await expect(net.layer(1)).toBeVisible()
      await net.neuron(1, 1).click()
      await net.bias(child.word('net.hidden', { layer: 1, neuron: 1 })).fill('20')
      await child.types('Enter')
      await asker.asksWhy()
    },
    'a motor behind it': () => asker.asksAbout(leftWheel),
    'its function': press('inside.curve'),
    'a link behind the layer': () => child.knobs.last().focus(),
    'up another neuron': () => list('inside.up').selectOption({ index: 1 }),
    'put away': press('inside.close'),
    'the field': async () => {
      await child.presses('lab.worldSettings')
      await field.check({ force: true })
      await child.types('Escape')
    },
    'no field': async () => {
      await child.presses('lab.worldSettings')
      await field.uncheck({ force: true })
      await child.types('Escape')
      await child.presses('network.why')
    },
  })
})
