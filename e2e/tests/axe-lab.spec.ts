// Rooms: world, robot, debug, robots, network, inside, editor, tour, content
// axe in the lab's tools: building, robot, time, networks, block help, tour.
import { sample } from '@botgarten/numbers/testing'
import { findsNothing, type States } from '../axe.ts'
import { BlockHands } from '../child-blocks.ts'
import { Builder } from '../child-build.ts'
import { node } from '../child-cards.ts'
import { AskingHands } from '../child-explained.ts'
import { Asker } from '../child-inside.ts'
import { NetHands } from '../child-network.ts'
import { RobotHands } from '../child-robot.ts'
import { TimeHands } from '../child-time.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensCard } from '../navigation.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

const sizes = [
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
]

const closes = (child: Child) => child.types('Escape')

const building: States = {
  'building, a thing in the hand': async (child) => {
    await child.opensLab('free')
    const builder = new Builder(child)
    await builder.begins()
    await builder.addsThing('triangle')
  },
  'its colours': (child) => new Builder(child).tool('build.colour').first().click(),
  'its numbers': (child) => new Builder(child).tool('build.numbers').click(),
  'a pen in the hand': (child) => new Builder(child).tool('build.addLine').click(),
  'the world': (child) => new Builder(child).opensWorldDialog(),
  'a picture refused': async (child) => {
    await closes(child)
    const builder = new Builder(child)
    await builder.choosesFile('build.ownPicture', 'diary.png', Buffer.from('Dear diary'), 'image/png')
    await expect(child.dialog('problem.pictureKind.title')).toBeVisible()
  },
  'Bo is rebuilt': async (child) => {
    await child.presses('parts.ok')
    await new Builder(child).ends()
    await new RobotHands(child).opens('build')
  },
  'a motor of his': (child) => new RobotHands(child).motor('B').getByRole('button').click(),
  'what Bo senses': async (child) => {
    const bo = new RobotHands(child)
    await bo.closes()
    await bo.opens('senses')
  },
  "Bo's keys": (child) => new RobotHands(child).opens('panel'),
  'the past': async (child) => {
    await child.opensLab('friendship')
    const time = new TimeHands(child)
    await child.pressesStart()
    await time.opens()
    await time.runsUntil(1)
    await time.goesBack('Home', 'Shift+ArrowRight')
  },
  'one robot more is asked for': async (child) => {
    await child.presses('time.toNow')
    await new TimeHands(child).asks()
  },
  'two robots': async (child) => {
    await child.presses('robots.shared')
    await expect(new TimeHands(child).chip(2)).toBeVisible()
  },
}

/** A card in the lab, and its dialog. */
const cardStates = (card: string): States => ({
  [`${card} in the lab`]: (child) => child.opensLab(card),
  [`the card ${card}`]: async (child) => {
    await child.presses('lab.card')
    await expect(child.page.getByRole('dialog')).toBeVisible()
  },
})
const cards = [
  ...sample(['incognito', 'rally', 'caution', 'loud-distance', 'interest'], 2),
  ...sample(['crossed-wires', 'if-then', 'lost-links', 'all-the-same'], 2),
  ...['either-or', 'chameleon', 'stop'],
].map(cardStates)

const waits = freeProgram('Waits', (make) => [make.wait(100), make.wait(200)])
const searched = {
  en: { more: 'random number' },
  de: { more: 'Zufallszahl' },
}

const blocks: States = {
  'what a block does': async (child) => {
    const hands = new AskingHands(child)
    await child.opensProjectAtHome('Waits', waits)
    await hands.asksByMenu(child.block('b2'))
    await hands.isTold('robControls_wait_time')
  },
  'the search in all blocks': async (child) => {
    await closes(child)
    const hands = new BlockHands(child)
    await hands.searches(searched[child.language].more)
    await child.presses('shelf.inAll')
    await expect(hands.hits.first()).toBeVisible()
  },
  'all blocks in the toolbox': async (child) => {
    await closes(child)
    await expect(child.button('editor.search')).toBeFocused()
  },
}

const networks: States = {
  'why, without an eye': async (child) => {
    const asker = new Asker(child)
    await asker.crashes()
    await asker.asksWhy()
    await asker.eye('frontLeft').click()
    const without = child.word('network.place.frontLeft')
    await expect(asker.pale('inside.without', { input: without })).toBeVisible()
  },
  'the function of two inputs': async (child) => {
    const asker = new Asker(child)
    await asker.asksOnTheWay()
    await child.presses('inside.curve')
    const second = { label: child.word('network.place.frontRight') }
    await asker.panel.getByRole('combobox').first().selectOption(second)
  },
  'a hidden layer, its neuron chosen': async (child) => {
    const net = new NetHands(child)
    await child.opensLab('friendship')
    await net.chooses('expert')
    await child.presses('net.addLayer')
    await net.neuron(1, 1).click()
    const name = child.word('net.hidden', { layer: 1, neuron: 1 })
    const does = child.page.getByRole('combobox', { name: child.word('net.activationOf', { name }) })
    await does.selectOption('threshold')
    await expect(net.layer(1)).toContainText(child.word('net.activation.threshold'))
  },
  'brains that are stored': async (child) => {
    const net = new NetHands(child)
    await net.opensShelf()
    await net.putsOnShelf('mild')
  },
  'Fear and Friendship side by side': async (child) => {
    await child.opensLab('fear')
    await child.typesWeight(leftEye, rightWheel, 0.8)
    await child.typesWeight(rightEye, leftWheel, 0.8)
    await child.presses('lab.card')
    await child.presses('robots.beside', { card: child.card('friendship') })
    const facts = { name: child.word('world.robot'), count: 4, of: 4 }
    await expect(child.page.getByText(child.word('robots.differ', facts))).toBeVisible()
  },
}

const tour = (child: Child) => child.page.getByRole('region', { name: child.word('tour.title'), exact: true })

const touring: States = {
  'the tour is offered': async (child) => {
    await opensCard(child, 'friendship')
    await expect(tour(child)).toContainText(child.word('tour.offer'))
  },
  'a block is to be tapped': async (child) => {
    await child.presses('tour.yes')
    await expect(child.block('wheelLeft')).toBeVisible()
  },
  'a neuron was tapped': async (child) => {
    await child
      .block('wheelLeft')
      .locator('.blocklyPath')
      .first()
      .click({ position: { x: 8, y: 14 } })
    await child.presses('tour.next')
    await node(child, 'showSum', child.word('neuron.motor', { OUTPUTNODE: leftWheel.motor })).click()
    await expect(tour(child)).toContainText(new RegExp(child.word('tour.litNodeAlone')))
  },
}

for (const language of languagesOf(import.meta.filename)) {
  for (const size of sizes)
    test.describe(`at ${size.width} × ${size.height}, in ${language}`, () => {
      test.use({ language, viewport: size })
      test('axe finds nothing where a child builds, rebuilds Bo, looks back and has two robots', ({
        child,
      }) => findsNothing(child, building))
    })

  test.describe(`in the lab, in ${language}`, () => {
    test.use({ language })
    test('axe finds nothing on cards', ({ child }) =>
      findsNothing(child, Object.assign({}, ...cards) as States))
    test('axe finds nothing in what blocks say and where they are searched', ({ child }) =>
      findsNothing(child, blocks))
    test('axe finds nothing inside networks', ({ child }) => findsNothing(child, networks))
  })

  test.describe(`on the tour, in ${language}`, () => {
    test.use({ language, newcomer: true })
    test('axe finds nothing in its offer', async ({ child }) => {
      const [offer] = Object.entries(touring)
      await findsNothing(child, Object.fromEntries([offer!]))
    })
    for (const [name, size] of Object.entries({
      'a phone': { width: 390, height: 844 },
      'a laptop at 200 %': { width: 683, height: 384 },
    }))
      test(`axe finds nothing on ${name}`, async ({ child, page }) => {
        await page.setViewportSize(size)
        await findsNothing(child, touring)
      })
  })
}
