// Rooms: content, network
import { setsKnob } from '../child-cards.ts'
import { BlockHands } from '../child-blocks.ts'
import { NetHands } from '../child-network.ts'
import { TimeHands } from '../child-time.ts'
import { leftWheel, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const part = (child: Child, colour: string) =>
  child.word('network.name', {
    label: child.word('neuron.channel', { COLOUR: child.word(`choice.${colour}`), SENSORPORT: '1' }),
    place: child.word('network.place.front'),
  })

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
        [part(child, 'red'), hidden(1), 0.6],
        [part(child, 'blue'), hidden(1), -1],
        [part(child, 'red'), hidden(2), -1],
        [part(child, 'blue'), hidden(2), 0.6],
        [hidden(1), lamp, 1],
        [hidden(2), lamp, 1],
      ] as const)
        await setsKnob(child, from, to, typed(child, weight))
      await hurries(child)
      for (const check of ['red', 'blue', 'white', 'black']) await child.seesCheck('either-or', check)
      await expect(page.getByText(child.word('lab.successTitle')).first()).toBeVisible()
    })

    test('rally: a network of its own drives a whole lap', async ({ child, page }) => {
      const hands = new BlockHands(child)
      await child.opensLab('rally')
      await hands.searches(child.word('block.ai_neural_network.name'))
      const loop = (await child.block('forever').boundingBox())!
      await hands.pulls(hands.hits.first(), { x: loop.x + 30, y: loop.y + 50 })
      await expect(child.block('forever').locator('.ai_neural_network')).toBeVisible()
      await expect(child.knobs).toHaveCount(4)

      await test.step('three parts of the floor in place of the two distances', async () => {
        // Blockly draws last what was chosen last.
        const lists = child.block('forever').locator('.ai_easy_list')
        const inputs = lists.filter({ hasNot: page.locator('.ai_nn_output_node') })
        await inputs.locator('.editor-minus').first().click()
        await expect(child.knobs).toHaveCount(2)
        await inputs.locator('.editor-minus').first().click()
        const row = (await inputs.boundingBox())!
        await hands.searches(child.word('choice.red'))
        const hit = hands.hits.filter({
          hasText: child.word('block.ai_nn_input_node_coloursensor_rgb_channel.row0').split(' ')[0]!,
        })
        await hands.pulls(hit.first(), { x: row.x + 40, y: row.y + 28 })
        await expect(child.knobs).toHaveCount(2)
        await child.presses('network.addSensor')
        await child.presses('network.addSensor')
        await expect(child.knobs).toHaveCount(6)
      })
      for (const [colour, wheel, weight] of [
        ['red', leftWheel, 1],
        ['blue', rightWheel, 1],
        ['green', leftWheel, 0.5],
        ['green', rightWheel, 0.5],
      ] as const)
        await setsKnob(child, part(child, colour), child.nameOf(wheel), typed(child, weight))
      await hurries(child)
      await child.seesCheck('rally', 'lap')
      await child.seesCheck('rally', 'stays')
      await expect(page.getByText(child.word('lab.successTitle')).first()).toBeVisible()
    })
  })
}
