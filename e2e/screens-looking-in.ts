import { expect } from '@playwright/test'
import { Asker } from './child-inside.ts'
import { Learner } from './child-learning.ts'
import { NetHands } from './child-network.ts'
import { RobotHands } from './child-robot.ts'
import { SortingHands } from './child-sorting.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from './child.ts'
import type { Screen } from './screens.ts'

async function opensNet(child: Child, phone: boolean) {
  await child.opensLab('friendship')
  if (phone) await child.turnsTo('networkTab')
  return new NetHands(child)
}

async function learns(child: Child, card: 'railway' | 'forest' | 'city') {
  const learner = new Learner(child)
  await learner.opens(card)
  await learner.learnsToTheEnd()
  return learner
}

async function makesMoves(child: Child, card: 'city') {
  await new Learner(child).opens(card)
  for (const move of [1, 2, 3]) {
    await child.presses('q.step')
    await expect.poll(async () => (await new Learner(child).moves()).shown).toBe(move)
    await expect(child.button('q.pause')).toHaveCount(0)
  }
}

/** Learns on the railway at once; then Bo drives. */
async function drives(child: Child) {
  const learner = new Learner(child)
  await learner.opens('railway')
  await learner.closes(2, 3)
  await learner.hurries()
  await child.presses('lab.start')
  await expect(child.button('lab.stop').first()).toBeVisible()
}

/** What opens a network or a learner to the eye; not on phones, where each has the screen to itself. */
const wide: readonly Screen[] = [
  {
    name: 'why',
    async show(child) {
      const asker = new Asker(child)
      await asker.asksOnTheWay()
      await asker.change.click()
    },
  },
  {
    name: 'function',
    async show(child) {
      await new Asker(child).asksOnTheWay()
      await child.presses('inside.curve')
    },
  },
  {
    name: 'field',
    async show(child) {
      await child.opensLab('fear')
      await child.typesWeight(leftEye, rightWheel, 0.8)
      await child.typesWeight(rightEye, leftWheel, 0.8)
      const isWide = child.page.viewportSize()!.width >= 1280
      await child.presses(isWide ? 'lab.worldSettings' : 'lab.menu')
      await child.page.getByRole('switch', { name: child.word('inside.field') }).check({ force: true })
      await child.types('Escape')
      await child.page.getByRole('img', { name: child.word('inside.fieldPicture') }).waitFor()
    },
  },
  {
    name: 'side-by-side',
    async show(child) {
      await child.opensLab('fear')
      await child.presses('lab.card')
      await child.presses('robots.beside', { card: child.card('friendship') })
      await child.seesWeight(leftEye, leftWheel, 0.8)
    },
  },
  { name: 'railway-learned', show: async (child) => void (await learns(child, 'railway')) },
  { name: 'forest-learned', show: async (child) => void (await learns(child, 'forest')) },
  {
    name: 'city-trials',
    show: async (child) => (await learns(child, 'city')).turnsTo('trials'),
  },
  {
    name: 'city-curves',
    show: async (child) => (await learns(child, 'city')).turnsTo('curves'),
  },
]

/** Learning by trying and sorting, as a child meets them at every width. */
const trying: readonly Screen[] = [
  { name: 'mars', show: (child) => new Learner(child).opens('mars') },
  { name: 'city', show: async (child) => makesMoves(child, 'city') },
  {
    name: 'city-tapped',
    async show(child) {
      await makesMoves(child, 'city')
      await new Learner(child).station(9).click()
    },
  },
  {
    name: 'forest-guess',
    async show(child) {
      const learner = new Learner(child)
      await learner.opens('forest')
      await learner.guesses(1, 4)
    },
  },
  {
    name: 'forest-guess-end',
    async show(child) {
      const learner = new Learner(child)
      await learner.opens('forest')
      await learner.closes(4, 6)
      await learner.guesses(1, 4, 3, 5, 7)
      await child.presses('q.guessing.learn')
      await learner.hurries()
      await expect(child.words('q.compare.title')).toBeVisible()
    },
  },
  { name: 'railway-drive', show: async (child) => void (await drives(child)) },
  {
    name: 'railway-senses',
    async show(child, phone) {
      await drives(child)
      if (!phone) await new RobotHands(child).opens('senses')
    },
  },
  {
    name: 'sorting',
    async show(child) {
      const sorting = new SortingHands(child)
      await sorting.opens()
      await sorting.sorts()
    },
  },
  {
    name: 'sorting-guess',
    async show(child) {
      const sorting = new SortingHands(child)
      await sorting.opens()
      await sorting.presses('guess.open')
    },
  },
  {
    name: 'tidy-up',
    async show(child) {
      await child.opensLab('tidy-up')
      await child.pressesStart()
      await child.seesSeconds(6)
      await child.presses('lab.pause')
    },
  },
]

export const lookingIn: readonly Screen[] = [
  ...trying,
  ...wide.map((screen) => ({ ...screen, neverPhone: true })),
  {
    name: 'net-settings',
    show: async (child, phone) => (await opensNet(child, phone)).opensSettings(),
  },
  {
    name: 'deep-net',
    async show(child, phone) {
      const net = await opensNet(child, phone)
      await net.chooses('expert')
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await child.presses('net.addLayer')
      await net.layer(1).waitFor()
    },
  },
  {
    name: 'brains',
    async show(child, phone) {
      const net = await opensNet(child, phone)
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await net.opensShelf()
      await net.putsOnShelf('Bo 1')
    },
  },
  ...(['crossed-wires', 'lost-links', 'all-the-same', 'if-then'] as const).map((card): Screen => ({
    name: card,
    show: (child) => child.opensLab(card),
  })),
  {
    name: 'repair-card',
    async show(child) {
      await child.opensLab('crossed-wires')
      await child.presses('lab.card')
    },
  },
]
