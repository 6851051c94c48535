import { expect } from '@playwright/test'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from './child.ts'
import { Builder } from './child-build.ts'
import { LooseHands } from './child-loose.ts'
import { opensSettings } from './child-cards.ts'
import { ProjectList } from './child-projects.ts'
import { RobotHands } from './child-robot.ts'
import { TimeHands } from './child-time.ts'
import { looseNet, projectFile, sayingProject } from './projects.ts'
import { lookingIn } from './screens-looking-in.ts'
import { mapScreens } from './screens-maps.ts'
import { questionnaireScreens } from './screens-questionnaires.ts'
import { raceScreens } from './screens-races.ts'
import { studyScreens } from './screens-study.ts'
import { trainingScreens } from './screens-training.ts'
import { tryingScreens } from './screens-trying.ts'

/** One picture: how a child gets there. `phone`: one part of the lab at a time. */
export interface Screen {
  readonly name: string
  /** Elsewhere all parts of the lab are on one screen. */
  readonly phoneOnly?: boolean
  readonly neverPhone?: boolean
  show(child: Child, phone: boolean): Promise<void>
}

async function setsFriendlyWeights(child: Child, phone: boolean) {
  if (phone) await child.turnsTo('networkTab')
  await child.typesWeight(leftEye, leftWheel, 0.8)
  await child.typesWeight(rightEye, rightWheel, 0.8)
  if (phone) await child.turnsTo('world')
}

/** Drives for some seconds of the robot's time, then holds it. */
async function drives(child: Child, seconds: number) {
  await child.pressesStart()
  await child.seesSeconds(seconds)
  await child.presses('lab.pause')
}

/** Drives a card's own program until it ends by itself, or for some seconds: a goal is still open. */
async function misses(child: Child, card: string, seconds?: number) {
  await child.opensLab(card)
  await child.pressesStart()
  if (seconds !== undefined) {
    await child.seesSeconds(seconds)
    await child.pressesStop()
  }
  await expect(child.page.getByText(child.word('missed.ask'))).toBeAttached()
}

/** A project whose first sensor is at a port where nothing is plugged in. */
const brokenProject = () =>
  projectFile('friendship', 'start').replace('ULTRASONIC_PORT_2', 'ULTRASONIC_PORT_4')

export const screens: readonly Screen[] = [
  { name: 'home', show: (child) => child.opensHome() },
  {
    name: 'about',
    async show(child) {
      await child.opensHome()
      await child.page.getByRole('link', { name: child.word('parts.about') }).click()
      await expect(child.words('about.noData')).toBeVisible()
    },
  },
  {
    name: 'new-project',
    async show(child) {
      await child.opensHome()
      await child.page.getByRole('button', { name: child.word('home.free') }).click()
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  { name: 'friendship', show: (child) => child.opensLab('friendship') },
  {
    name: 'friendship-running',
    async show(child, phone) {
      await child.opensLab('friendship')
      await setsFriendlyWeights(child, phone)
      await drives(child, 3)
    },
  },
  {
    name: 'friendship-network',
    phoneOnly: true,
    async show(child) {
      await child.opensLab('friendship')
      await setsFriendlyWeights(child, true)
      await child.turnsTo('networkTab')
    },
  },
  {
    name: 'friendship-program',
    phoneOnly: true,
    async show(child) {
      await child.opensLab('friendship')
      await child.turnsTo('program')
      await child.seesBlocks()
    },
  },
  { name: 'fear', show: (child) => child.opensLab('fear') },
  { name: 'free', show: (child) => child.opensLab('free') },
  {
    name: 'card',
    async show(child) {
      await child.opensLab('friendship')
      await child.presses('lab.card')
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'hint',
    async show(child) {
      await child.opensLab('friendship')
      await child.presses('lab.hint')
      await expect(child.page.getByRole('region', { name: child.word('lab.hint') })).toBeVisible()
    },
  },
  { name: 'first-drive', show: (child) => child.opensLab('forward') },
  { name: 'missed', show: (child) => misses(child, 'forward') },
  { name: 'missed-network', show: (child) => misses(child, 'friendship', 3) },
  {
    name: 'loose',
    async show(child, phone) {
      await child.opensProjectAtHome('Loose', looseNet('Loose'))
      if (phone) await child.turnsTo('networkTab')
      await new LooseHands(child).seesLoose()
    },
  },
  ...(['loud-distance', 'say-it', 'interest'] as const).map((name): Screen => ({
    name,
    show: (child) => child.opensLab(name),
  })),
  { name: 'chameleon', show: (child) => child.opensLab('chameleon') },
  {
    name: 'build',
    async show(child) {
      await child.opensLab('free')
      const builder = new Builder(child)
      await builder.begins()
      await builder.addsThing('circle')
    },
  },
  {
    name: 'robot',
    async show(child, phone) {
      await child.opensLab('friendship')
      const hands = new RobotHands(child)
      await hands.opens('build')
      if (!phone) await hands.mark('ultrasonic', '2').click()
    },
  },
  {
    name: 'senses',
    async show(child) {
      await child.opensLab('friendship')
      await new RobotHands(child).opens('senses')
    },
  },
  {
    name: 'time',
    async show(child, phone) {
      await child.opensLab('friendship')
      await setsFriendlyWeights(child, phone)
      const time = new TimeHands(child)
      await child.pressesStart()
      await time.opens()
      await time.runsUntil(3)
      await time.goesBack('Home', 'Shift+ArrowRight')
    },
  },
  {
    name: 'two-robots',
    async show(child, phone) {
      await child.opensLab('friendship')
      await setsFriendlyWeights(child, phone)
      await new TimeHands(child).adds('shared')
      await drives(child, 2)
    },
  },
  {
    name: 'badges',
    async show(child, phone) {
      await child.opensProjectAtHome('Hallo', sayingProject('Hallo'))
      if (phone) await child.turnsTo('world')
      await child.pressesStart()
      const hello = child.word('world.badge.word', { text: 'Hallo!' })
      const place = 'bo badge speech'
      await expect
        .poll(async () => (await child.painted.places()).find(({ name }) => name === place)?.text)
        .toContain(hello)
      await child.presses('lab.pause')
    },
  },
  {
    name: 'projects',
    async show(child, phone) {
      for (const card of ['friendship', 'fear']) {
        await child.opensLab(card)
        if (phone) await child.turnsTo('networkTab')
        await child.typesWeight(leftEye, leftWheel, 0.8)
        await child.seesSaved()
      }
      await new ProjectList(child).opens()
    },
  },
  {
    name: 'settings',
    async show(child) {
      await child.opensHome()
      await opensSettings(child, 'home')
    },
  },
  {
    name: 'share',
    async show(child) {
      await child.opensLab('friendship')
      await child.presses('lab.menu')
      await child.presses('parts.share')
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'about',
    async show(child) {
      await child.page.goto('/about')
      await expect(child.page.getByRole('heading', { level: 1 })).toBeVisible()
    },
  },
  {
    name: 'help',
    async show(child, phone) {
      await child.opensLab('friendship')
      await child.opensFile('broken.botgarten.json', brokenProject())
      if (phone) await child.turnsTo('program')
      const title = child.word('problem.noDistanceSensorEmpty.title', { port: 4 })
      await expect(child.page.getByText(title, { exact: true }).first()).toBeVisible()
    },
  },
  ...lookingIn,
  ...trainingScreens,
  ...tryingScreens,
  ...mapScreens,
  ...questionnaireScreens,
  ...studyScreens,
  ...raceScreens,
]
