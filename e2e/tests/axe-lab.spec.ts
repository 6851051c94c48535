// Rooms: world, robot, debug, robots
import { axeFindings } from '../axe.ts'
import { opensSettings } from '../child-cards.ts'
import { Builder } from '../child-build.ts'
import { ProjectList } from '../child-projects.ts'
import { RobotHands } from '../child-robot.ts'
import { TimeHands } from '../child-time.ts'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

// accessible.spec.ts and axe.spec.ts look at 1366.
const sizes = [
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
]

type Faces = { readonly [name: string]: (child: Child) => Promise<unknown> }

const closes = (child: Child) => child.types('Escape')

/** What accessible.spec.ts does not see of the lab: building, the robot, time, several robots. */
const labFaces: Faces = {
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
  'what Bo feels': async (child) => {
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

/** What axe.spec.ts does not see of the pages around it. */
const pageFaces: Faces = {
  'settings at home': async (child) => {
    await child.opensHome()
    await opensSettings(child, 'home')
  },
  'a new name': async (child) => {
    const list = new ProjectList(child)
    await list.opens()
    await list.opensFile(
      'Uno.json',
      freeProgram('Uno', (make) => [make.wait(1)]),
    )
    await expect(child.page.getByRole('heading', { level: 1 })).toHaveText('Uno')
    await child.seesSaved()
    await list.opens()
    await list.chooses('Uno', 'rename')
  },
  'into the bin': async (child) => {
    await child.presses('projects.cancel')
    await new ProjectList(child).chooses('Uno', 'throw')
    await new ProjectList(child).hears('projects.thrown', { name: 'Uno' })
  },
  'a full bin': (child) => new ProjectList(child).goesToBin(),
  'is it to be emptied?': (child) => child.presses('projects.emptyBin'),
  'a home file is read': async (child) => {
    await child.presses('projects.cancel')
    const list = new ProjectList(child)
    await list.opens()
    await list.opensFile('home.json', '{"botgartenHome":1,"projects":[{}]}')
    await expect(child.dialog('projects.mergedTitle')).toBeVisible()
  },
  'a link that is cut': async (child) => {
    // By address: a link that was cut.
    await child.page.goto('/open#v1.abc')
    await child.seesTitle()
  },
}

async function findsNothing(child: Child, faces: Faces) {
  const found: { [face: string]: string[] } = {}
  for (const [face, show] of Object.entries(faces)) {
    await test.step(face, () => show(child))
    found[face] = await axeFindings(child.page)
  }
  expect(found).toEqual(Object.fromEntries(Object.keys(faces).map((face) => [face, []])))
}

for (const language of languagesOf(import.meta.filename))
  for (const size of sizes)
    test.describe(`at ${size.width} × ${size.height}, in ${language}`, () => {
      test.use({ language, viewport: size })
      test.beforeEach(({ page }) => page.emulateMedia({ reducedMotion: 'reduce' }))

      test('axe finds nothing where a child builds, rebuilds Bo, looks back and has two robots', ({
        child,
      }) => findsNothing(child, labFaces))
      test('axe finds nothing in what the pages about projects ask', ({ child }) =>
        findsNothing(child, pageFaces))
    })
