import type { Locator } from '@playwright/test'
import { Builder } from '../child-build.ts'
import { TimeHands } from '../child-time.ts'
import type { Child } from '../child.ts'
import { picture } from '../png.ts'
import { freeProgram } from '../projects.ts'
import { expect, opensCard, opensProject, test } from '../gate/gate.ts'
import { goesThrough, type Steps } from '../steps.ts'

test.use({ language: 'en' })

/** Types into fields one after the other. */
async function types(fields: readonly (readonly [Locator, string])[]) {
  for (const [field, text] of fields) {
    await field.fill(text)
    await field.press('Enter')
  }
}

/** Steps about obstacles and fields of colour, with their properties. */
function thingSteps(child: Child, builder: Builder): Steps {
  const { page } = child
  const field = (name: string) => builder.field(`build.${name}`).last()
  const handle = (thing: string) => child.button('build.size', { thing: child.word(thing) })
  const turner = (thing: string) =>
    page.getByRole('slider', { name: child.word('world.turn', { thing: child.word(thing) }), exact: true })
  const lookAlike = (look: string) =>
    builder.tool('build.addThing', { shape: child.word(`world.thing.${look}`) })
  /** Bo comes last. */
  const topmost = () => builder.things.nth(-2)
  return {
    'the tools to build': async () => {
      await child.opensLab('free')
      await builder.begins()
    },
    'a rectangle': () => builder.addsThing('rectangle'),
    'its colours': () => builder.tool('build.colour').first().click(),
    'it is red': () => builder.tool('build.colours.red').click(),
    'its colours again': () => builder.tool('build.colour').first().click(),
    'it has another colour': () => page.getByLabel(child.word('build.otherColour')).fill('#12ab34'),
    'Bo can push it': () => builder.tool('build.movable').click(),
    'its numbers': () => builder.tool('build.numbers').click(),
    'a number that is none': async () => {
      await types([[field('x'), 'far']])
      await expect(field('x')).toHaveAttribute('aria-invalid', 'true')
    },
    'all its numbers': async () => {
      await types([
        ...([[field('x'), '90'], [field('y'), '80.5'], [field('angle'), '30']] as const), // prettier-ignore
        ...([[field('width'), '50'], [field('height'), '44']] as const), // prettier-ignore
      ])
      await expect(field('x')).toHaveAttribute('aria-invalid', 'false')
    },
    'no numbers': () => builder.tool('build.numbers').click(),
    'it is pulled larger by hand and by keys': async () => {
      const from = await child.middleOf(handle('world.thing.rectangle'))
      await child.drags(from, { x: from.x + 24, y: from.y + 18 })
      await handle('world.thing.rectangle').press('Shift+ArrowRight')
      await builder.tool('build.numbers').click()
    },
    'no numbers again': () => builder.tool('build.numbers').click(),
    'it is turned by keys': () => turner('world.thing.rectangle').press('ArrowLeft'),
    'it is moved by keys': () => builder.all('world.thing.rectangle').press('Shift+ArrowUp'),
    'a triangle': () => builder.addsThing('triangle'),
    'one further down': async () => {
      await builder.tool('build.backward').click()
      await expect(topmost()).toHaveAccessibleName(/rectangle/)
      await builder.tool('build.forward').click()
      await expect(topmost()).toHaveAccessibleName(/triangle/)
      await builder.tool('build.backward').click()
      await builder.tool('build.copy').click()
    },
    'the copy goes': () => builder.tool('build.remove').click(),
    'a tree': () => lookAlike('tree').click(),
    'a stone, a crate and a ball': async () => {
      for (const look of ['rock', 'crate', 'ball']) await lookAlike(look).click()
    },
    'how far it is across': async () => {
      await builder.tool('build.numbers').click()
      await types([[field('across'), '60']])
    },
    'nothing is selected': async () => {
      await builder.world.focus()
      await child.types('Escape')
    },
    'a thing is selected by keys': () => builder.all('world.thing.rectangle').press('Enter'),
    'a field of colour': () => builder.addsField('rectangle'),
    'it is turned': async () => {
      const from = await child.middleOf(turner('build.area'))
      await child.drags(from, { x: from.x, y: from.y - 60 })
    },
    'the field is turned by keys': () => turner('build.area').press('ArrowDown'),
    'the field is moved by keys': () => builder.all('build.area').press('Shift+ArrowLeft'),
    'the field is dragged': async () => {
      const from = await child.middleOf(builder.all('build.area'))
      await child.drags(from, { x: from.x - 40, y: from.y + 60 })
    },
    'a circle and a triangle on the floor': async () => {
      await builder.addsField('circle')
      await builder.addsField('triangle')
    },
    'the first field is selected by keys': () => builder.all('build.area').first().press('Enter'),
    'the robot is moved and turned by keys': async () => {
      await child.bo.press('Shift+ArrowUp')
      await child.bo.press(',')
      await child.bo.press('Enter')
    },
    'the robot is turned by its handle': () => turner('world.robot').press('ArrowRight'),
    'nothing is built any more': () => builder.ends(),
  }
}

test('things of the world are built, step by step', { tag: '@world' }, async ({ child }) => {
  await goesThrough(child, 'world-things', thingSteps(child, new Builder(child)))
})

/** The most things that a world may have. */
const crowd = JSON.stringify({
  robotPoses: [[{ x: 0.2, y: 0.3, theta: 0 }, { x: 0.2, y: 0.3, theta: 0 }]], // prettier-ignore
  obstacles: Array.from({ length: 100 }, () => ({
    ...{ x: 0.4, y: 0.4, w: 0.1, h: 0.15, theta: 0, color: '#33B8CA', form: 'RECTANGLE', type: 'OBSTACLE' },
  })),
  colorAreas: [],
  marker: [],
})

/** Steps about walls, lines and the world as a whole. */
function lineSteps(child: Child, builder: Builder): Steps {
  const { page } = child
  const field = (name: string) => builder.field(`build.${name}`).last()
  const dialog = child.dialog('build.world')
  const size = (name: string) => dialog.getByLabel(child.word(`build.${name}`), { exact: true })
  const presses = async (right: number, down: number) => {
    const { x, y } = await builder.spot(right, down)
    await page.mouse.click(x, y)
  }
  const line = () => builder.all('build.line').last()
  const draws = async (...spots: readonly (readonly [number, number])[]) => {
    for (const [at, [right, down]] of spots.entries()) {
      const { x, y } = await builder.spot(right, down)
      await page.mouse.move(x, y, { steps: 3 })
      if (at === 0) await page.mouse.down()
    }
  }
  return {
    'another world': async () => {
      await child.opensLab('free')
      await builder.begins()
      await builder.opensWorldDialog()
      await page.getByRole('button', { name: child.word('worldName.maze') }).click()
      await expect(builder.all('world.thing.wall').first()).toBeVisible()
    },
    'worlds to choose from': async () => {
      await builder.opensWorldDialog()
      await expect(page.getByRole('button', { name: child.word('worldName.maze') })).toBeVisible()
    },
    'no dialog by keys': () => child.types('Escape'),
    'the tools to build': async () => {
      await opensCard(child, 'friendship')
      await builder.begins()
    },
    'the pen for walls': () => builder.tool('build.addWall').click(),
    'a wall is being drawn': () => draws([0.3, 0.85], [0.7, 0.85]),
    'a wall': () => page.mouse.up(),
    'the pen for lines': () => builder.tool('build.addLine').click(),
    'one point of a line': () => presses(0.42, 0.4),
    'two points of a line': () => presses(0.6, 0.5),
    'a line': () => builder.tool('build.done').click(),
    'no pen': async () => {
      await builder.tool('build.addLine').click()
      await line().press('Enter')
    },
    'its numbers': () => builder.tool('build.numbers').click(),
    'all its numbers': async () => {
      await types([
        [field('x'), '100'],
        [field('y'), '90'],
        [field('lineWidth'), '7'],
      ])
      await builder.tool('build.numbers').click()
    },
    'its first point is pulled': async () => {
      const from = await child.middleOf(builder.tool('build.bend', { number: 1 }))
      await child.drags(from, { x: from.x - 20, y: from.y + 30 })
    },
    'its second point is moved by keys': () =>
      builder.tool('build.bend', { number: 2 }).press('Shift+ArrowDown'),
    'the line is moved by keys': () => line().press('Shift+ArrowRight'),
    'the line is let go of': async () => {
      await builder.world.focus()
      await child.types('Escape')
    },
    'the line is dragged': async () => {
      const { x, y, width, height } = (await line().boundingBox())!
      const from = { x: x + width / 2, y: y + height / 2 }
      await child.drags(from, { x: from.x + 30, y: from.y + 20 })
    },
    'a wall and a line by keys': async () => {
      await builder.tool('build.addWall').press('Enter')
      await builder.tool('build.addLine').press('Enter')
    },
    'about the whole world': () => builder.opensWorldDialog(),
    'its size': () => types([[size('width'), '400'], [size('height'), '240']]), // prettier-ignore
    'its floor is yellow': () =>
      dialog.getByRole('button', { name: child.word('build.colours.yellow') }).click(),
    'the dialog is closed': async () => {
      await dialog.getByRole('button', { name: child.word('parts.close'), exact: true }).click()
      const file = JSON.parse(await builder.savesScene()) as object
      expect(JSON.stringify(file)).toContain('"width":400')
    },
    'a picture on the floor': async () => {
      await builder.choosesFile('build.ownPicture', 'a.png', picture(30, 20), 'image/png')
      await expect.poll(() => builder.savesScene()).toContain('"asset"')
      await builder.opensWorldDialog()
    },
    'a full world': async () => {
      await child.types('Escape')
      await builder.choosesFile('build.openScene', 'a.json', Buffer.from(crowd))
      await expect(builder.all('world.thing.rectangle')).toHaveCount(100)
      await builder.addsThing('circle')
      await expect(page.getByText(child.word('build.full', { most: 100 }))).toBeVisible()
    },
    'the full world goes': async () => {
      await builder.ends()
      await child.presses('lab.undo')
    },
  }
}

test('walls, lines and a whole world, step by step', { tag: '@world' }, async ({ child }) => {
  await goesThrough(child, 'world-lines', lineSteps(child, new Builder(child)))
})

/** Shows a word, says one, drives and ends. */
const told = freeProgram('Told', (make) => {
  const text = (TEXT: string) => make.block('text', { fields: { TEXT } })
  return [
    make.block('robActions_display_text', {
      values: { OUT: text('Hi'), COL: make.number(0), ROW: make.number(1) },
    }),
    make.block('robActions_sayText', { values: { OUT: text('Hello') } }),
    make.drive(60, 30),
  ]
})
/** Behind the garden's start stands the fence. */
const stuck = freeProgram('Stuck', (make) => [make.drive(60, -50_000)])

/** A run whose end is the same every time. */
function runSteps(child: Child, time: TimeHands): Steps {
  const { page } = child
  const { world } = new Builder(child)
  const width = () => child.painted.wheelsApart()
  const grows = async (act: () => Promise<void>) => {
    const before = await width()
    await act()
    await expect.poll(width).toBeGreaterThan(before * 1.02)
  }
  const shrinks = async (act: () => Promise<void>) => {
    const before = await width()
    await act()
    await expect.poll(width).toBeLessThan(before * 0.98)
  }
  const drag = async (from: number, to: number) => {
    const { x, y, width, height } = (await time.slider.boundingBox())!
    const at = (share: number) => ({ x: x + width * share, y: y + height / 2 })
    await child.drags(at(from), at(to))
  }
  return {
    'a program that tells': () => opensProject(child, 'Told', told),
    'a run to its end': async () => {
      await child.pressesStart()
      await time.opens()
      await expect(child.button('lab.start').first()).toBeVisible()
      await expect(page.getByText(child.word('world.stopped'))).toBeAttached()
    },
    'the first moment': () => time.slider.press('Home'),
    'steps back and on, and now again': async () => {
      await time.slider.press('Shift+ArrowRight')
      await expect.poll(() => time.at()).toBe(1)
      await child.presses('time.back')
      await expect.poll(() => time.at()).toBeLessThan(1)
      for (let steps = 0; steps < 8; steps += 1) await child.presses('time.forth')
      await expect.poll(() => time.at()).toBeGreaterThan(1)
      await child.presses('time.toNow')
    },
    'a moment by the mouse': () => drag(0.1, 0.2),
    'on from there to the end': async () => {
      await child.presses('time.goOn')
      await expect(child.button('lab.start').first()).toBeVisible()
    },
    'no bar of time': () => child.presses('time.close'),
    'a robot that is stuck': async () => {
      await opensProject(child, 'Stuck', stuck)
      await child.presses('world.all')
      await child.pressesStart()
      await time.opens()
      await time.hurries()
      await expect(child.words('world.lost')).toBeVisible()
      await child.presses('lab.pause')
      await expect(page.getByText(child.word('world.bumped'))).toBeAttached()
    },
    'it is brought back': () => child.presses('world.bringBack'),
    'the floor nearer and farther, and Bo driven and turned by keys': async () => {
      await child.presses('time.close')
      await child.pressesStop()
      await child.presses('lab.resetWorld')
      await child.presses('world.all')
      const whole = await width()
      await grows(() => child.presses('world.nearer'))
      await grows(() => child.presses('world.nearer'))
      await shrinks(() => child.presses('world.farther'))
      await child.presses('world.all')
      await expect.poll(width).toBeCloseTo(whole, 0)
      const { x, y } = await child.middleOf(world)
      await page.mouse.move(x, y)
      await grows(() => page.mouse.wheel(0, -200))
      await shrinks(() => world.press('0'))
      await grows(() => world.press('+'))
      await child.presses('world.all')
      await world.focus()
      await page.keyboard.down('ArrowUp')
      await child.seesDriving()
      await page.keyboard.up('ArrowUp')
      await child.seesStanding()
      await child.presses('lab.resetWorld')
      const before = await child.boStands()
      await child.bo.press(',')
      await expect.poll(() => child.boStands()).not.toBe(before)
    },
    'Bo is turned by its handle': async () => {
      await child.bo.press('Enter')
      const name = child.word('world.turn', { thing: child.word('world.robot') })
      await page.getByRole('slider', { name, exact: true }).press('ArrowLeft')
    },
    'a thing is selected and moved by keys': async () => {
      await child.thing('tree').press('Enter')
      await child.thing('tree').press('Shift+ArrowLeft')
    },
    'nothing is selected': () => child.types('Escape'),
    'a thing is dragged': () => child.dragsThing('tree', { x: 30, y: 20 }),
  }
}

test('a run, its time and its floor, step by step', { tag: '@world' }, async ({ child }) => {
  const hides =
    /Bo bumped into it\.|Bo stands still\.|\d+(\.\d+)? s(econds( ago)?)?( of \d+\.\d s)?$|"Moment of the run": .*|(?<=Moment of the run value\w+: ).*/
  await goesThrough(child, 'world-run', runSteps(child, new TimeHands(child)), { hides })
})
