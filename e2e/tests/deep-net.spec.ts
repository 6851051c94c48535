// Rooms: network
import { readFile } from 'node:fs/promises'
import { leftEye, leftWheel, rightEye } from '../child.ts'
import { NetHands } from '../child-network.ts'
import { expect, test } from '../house.ts'
import { emptyNet } from '../projects.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language })

    test('builds a hidden layer with the mouse, sets it, and takes it back', async ({ child }) => {
      const net = new NetHands(child)
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await net.chooses('explorer')
      await expect(child.knobs).toHaveCount(4)
      await child.presses('net.addLayer')
      await expect(net.layer(1)).toBeVisible()
      await expect(child.knobs).toHaveCount(12)

      await test.step('a neuron more and less', async () => {
        await child.presses('net.more', { layer: 1 })
        await expect(child.knobs).toHaveCount(16)
        await child.presses('net.fewer', { layer: 1 })
        await child.presses('net.fewer', { layer: 1 })
        await expect(child.knobs).toHaveCount(8)
      })

      await test.step('a negative weight and a bias are in its sum', async () => {
        const from = child.nameOf(leftEye)
        const to = child.word('net.hidden', { layer: 1, neuron: 1 })
        const knob = child.page.getByRole('slider', {
          name: child.word('network.weight', { from, to }),
          exact: true,
        })
        await knob.focus()
        for (const key of (-0.5).toLocaleString(language)) await child.types(key)
        await child.types('Enter')
        await expect(knob).toHaveAttribute('aria-valuenow', '-0.5')
        await net.bias(to).fill('80')
        await net.bias(to).press('Enter')
        await expect.poll(() => child.painted.textIn(net.neuron(1, 1))).toBe('30')
      })

      await test.step('taken out, the old weights are there again; undo brings the layer back', async () => {
        await child.presses('net.fewer', { layer: 1 })
        await child.presses('net.removeLayer', { layer: 1 })
        await expect(child.knobs).toHaveCount(4)
        await child.seesWeight(leftEye, leftWheel, 0.5)
        await child.presses('lab.undo')
        await expect(net.layer(1)).toBeVisible()
        await expect.poll(() => child.painted.textIn(net.neuron(1, 1))).toBe('30')
      })

      await test.step('a starter sees it all and can change nothing of it', async () => {
        await net.chooses('starter')
        await expect.poll(() => child.painted.textIn(net.neuron(1, 1))).toBe('30')
        await expect(child.button('net.addLayer')).toHaveCount(0)
        await expect(child.knobs.first()).toHaveAttribute('aria-readonly', 'true')
      })
      await child.seesSaved()
      await child.reloads()
      await expect.poll(() => child.painted.textIn(net.neuron(1, 1))).toBe('30')
    })

    test('builds a hidden layer with keys alone, and chooses what its neurons do', async ({ child }) => {
      const net = new NetHands(child)
      await child.opensLab('friendship')
      await child.tabsAndPresses('network.settings')
      await child.tabsTo(net.level('starter'))
      await child.types('ArrowDown', 'ArrowDown', 'Escape')
      await child.tabsAndPresses('net.addLayer')
      await expect(net.layer(1)).toBeVisible()
      await child.tabsTo(net.neuron(1, 1))
      await child.types('Enter')
      const name = child.word('net.hidden', { layer: 1, neuron: 1 })
      const does = child.page.getByRole('combobox', { name: child.word('net.activationOf', { name }) })
      await does.selectOption('threshold')
      await expect(net.layer(1)).toContainText(child.word('net.activation.threshold'))
      await expect(child.canvas).toContainText(child.word('choice.threshold'))
      await child.tabsTo(net.bias(name))
      await child.types('ArrowUp')
      await expect.poll(() => child.painted.textIn(net.neuron(1, 1))).toBe('100')
    })

    test('keeps brains on a shelf: names, a file, and what is refused', async ({ child }) => {
      const net = new NetHands(child)
      await child.opensLab('friendship')
      await child.typesWeight(rightEye, leftWheel, 0.75)
      await net.opensShelf()
      await net.putsOnShelf('mild')
      const [download] = await Promise.all([
        child.page.waitForEvent('download'),
        child.presses('net.save', { name: 'mild' }),
      ])
      const file = await readFile(await download.path(), 'utf8')

      await test.step('a new name, gone, back from its file, on the knobs', async () => {
        await net.onShelf('mild').fill('wild')
        await net.onShelf('mild').press('Enter')
        await child.presses('net.remove', { name: 'wild' })
        await expect(net.onShelf('wild')).toHaveCount(0)
        await net.brings(file)
        await net.isTold('net.isThere')
        await child.types('Escape')
        await child.page.getByTitle(child.word('lab.resetWeights')).click()
        await child.seesWeight(rightEye, leftWheel, 0)
        await net.opensShelf()
        await child.presses('net.take')
        await net.isTold('net.taken', { name: 'mild' })
        await child.types('Escape')
        await child.seesWeight(rightEye, leftWheel, 0.75)
      })

      await test.step('files that are no brains for it are refused, each with its reason', async () => {
        await net.opensShelf()
        await net.brings(file.replace('0.75', 'NaN'))
        await net.isTold('net.refused.notANumber')
        await net.brings('Dear diary')
        await net.isTold('net.refused.notJson')
        await net.brings('{"botgarten":1}')
        await net.isTold('net.refused.isAProject')
        const { layers } = JSON.parse(file) as { layers: object[][] }
        const withLayers = (changed: object[][]) => JSON.stringify({ ...JSON.parse(file), layers: changed })
        await net.brings(withLayers([layers[0]!, Array<object>(300).fill(layers[1]![0]!)]))
        await net.isTold('net.refused.tooManyNeurons', { count: 302, most: 256 })
        await net.brings(withLayers([layers[0]!, [layers[1]![0]!]]))
        await net.isTold('net.refused.otherProgram', { there: '2 → 1', here: '2 → 2' })
      })
    })

    test('is told what is wrong with a net of no inputs, and with one of 300 neurons', async ({ child }) => {
      await child.opensProjectAtHome('Nothing', emptyNet('Nothing', '3', []))
      await child.presses('lab.start')
      await expect(child.words('problem.noInputs.title').first()).toBeVisible()
      await child.opensProject('Giant', emptyNet('Giant', '300', ['2']))
      await child.presses('lab.start')
      await expect(child.words('problem.tooManyInLayer.title', { count: 300 }).first()).toBeVisible()
    })
  })
