// Rooms: content, network
import { colourInput, setsKnob } from '../child-cards.ts'
import { BlockHands } from '../child-blocks.ts'
import { NetHands } from '../child-network.ts'
import { TimeHands } from '../child-time.ts'
import { leftWheel, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

/** Weights as a child of this language types them. */
const typed = (child: Child, weight: number) => weight.toLocaleString(child.language)

/** Starts, as fast as it can. */
async function hurries(child: Child) {
  await child.pressesStart()
  await new TimeHands(child).hurries()
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`in ${language}`, () => {
    test.use({ language })

    test('brains to repair bear a wrench at home; if-then has two panes until Bo 2 is chosen', async ({
      child,
      page,
    }) => {
      await child.opensHome()
      const wrench = page.getByRole('img', { name: child.word('home.repair') })
      const repair = page.getByRole('listitem').filter({ has: wrench }).getByRole('link')
      await expect(repair).toHaveText(
        ['crossed-wires', 'lost-links', 'all-the-same'].map((id) => child.card(id)),
      )
      await page.getByRole('link', { name: child.card('if-then'), exact: true }).click()
      await child.seesLab()
      const network = page.getByRole('heading', { name: child.word('lab.network'), exact: true })
      await expect(network).toHaveCount(0)
      await new TimeHands(child).chip(2).click()
      await expect(network).toBeVisible()
      await expect(child.knobs).toHaveCount(4)
      await new TimeHands(child).chip(1).click()
      await expect(network).toHaveCount(0)
    })

    test('either, or: two hidden neurons do what no single layer does', async ({ child, page }) => {
      const net = new NetHands(child)
      const lamp = child.word('neuron.lamp', { OUTPUTNODE: child.word('choice.green') })
      await child.opensLab('either-or')
      await net.chooses('explorer')
      await child.presses('net.addLayer')
      await child.presses('net.fewer', { layer: 1 })
      await expect(child.knobs).toHaveCount(6)
      const hidden = (neuron: number) => child.word('net.hidden', { layer: 1, neuron })
      for (const [from, to, weight] of [
        [colourInput(child, 'channel', 'red'), hidden(1), 0.6],
        [colourInput(child, 'channel', 'blue'), hidden(1), -1],
        [colourInput(child, 'channel', 'red'), hidden(2), -1],
        [colourInput(child, 'channel', 'blue'), hidden(2), 0.6],
        [hidden(1), lamp, 1],
        [hidden(2), lamp, 1],
      ] as const)
        await setsKnob(child, from, to, typed(child, weight))
      await hurries(child)
      for (const check of ['red', 'blue', 'white', 'black']) await child.seesCheck('either-or', check)
      await expect(page.getByText(child.word('lab.successTitle')).first()).toBeVisible()
    })

    test('interest: the network comes with the colours and words of the card, below the drive', async ({
      child,
      page,
    }) => {
      await child.opensLab('interest')
      // Five actions: the network, a knob for each colour, Start.
      await child.presses('network.putOne')
      await expect(child.block('repeat').locator('.ai_neural_network')).toBeVisible()
      await expect(child.knobs).toHaveCount(9)
      for (const [colour, word] of [
        ['red', 'A'],
        ['yellow', 'B'],
        ['green', 'C'],
      ] as const)
        await setsKnob(
          child,
          colourInput(child, 'colour', colour),
          child.word('neuron.text', { OUTPUTNODE: word }),
          '1',
        )
      await hurries(child)
      for (const colour of ['red', 'yellow', 'green']) await child.seesCheck('interest', colour, true, 60_000)
      await expect(page.getByText(child.word('lab.successTitle')).first()).toBeVisible()
    })

    test('rally: the network comes with the parts of the floor, and drives a whole lap', async ({
      child,
      page,
    }) => {
      await child.opensLab('rally')
      // Six actions: the network, four knobs, Start.
      await child.presses('network.putOne')
      await expect(child.block('forever').locator('.ai_neural_network')).toBeVisible()
      await expect(child.knobs).toHaveCount(6)
      for (const [colour, wheel, weight] of [
        ['red', leftWheel, 1],
        ['blue', rightWheel, 1],
        ['green', leftWheel, 0.5],
        ['green', rightWheel, 0.5],
      ] as const)
        await setsKnob(
          child,
          colourInput(child, 'channel', colour),
          child.nameOf(wheel),
          typed(child, weight),
        )
      await hurries(child)
      await child.seesCheck('rally', 'lap')
      await child.seesCheck('rally', 'stays')
      await expect(page.getByText(child.word('lab.successTitle')).first()).toBeVisible()
    })

    test('a network from the toolbox gets the parts of the floor by its plus', async ({ child }) => {
      const hands = new BlockHands(child)
      await child.opensLab('rally')
      await hands.searches(child.word('block.ai_neural_network.name'))
      const loop = (await child.block('forever').boundingBox())!
      await hands.pulls(hands.hits.first(), { x: loop.x + 30, y: loop.y + 50 })
      await expect(child.block('forever').locator('.ai_neural_network')).toBeVisible()
      await expect(child.knobs).toHaveCount(4)
      for (const [index, colour] of ['red', 'green', 'blue'].entries()) {
        await child.addsNeuron('addSensor', colourInput(child, 'channel', colour))
        await expect(child.knobs).toHaveCount(6 + 2 * index)
      }
      await child.plus('addSensor').click()
      const grey = colourInput(child, 'colour', 'grey')
      await expect(child.offered.filter({ hasText: grey })).toHaveCount(1)
      // The network has all parts of the floor now.
      await expect(child.offered.filter({ hasText: colourInput(child, 'channel', 'red') })).toHaveCount(0)
    })
  })
}
