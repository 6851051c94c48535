import type { Locator, Page } from '@playwright/test'
import { MapMaker } from '../child-maps.ts'
import { Learner } from '../child-learning.ts'
import type { Child } from '../child.ts'
import type { Spot } from '../hand.ts'
import { picture } from '../png.ts'
import { refusesToKeep } from '../failing-storage.ts'
import { expect, follows, test } from '../gate/gate.ts'
import { goesThrough, type Steps } from '../steps.ts'

test.use({ language: 'en' })

/** The states of autosave and of the tries. A step of its own reads the tries. */
const hides =
  /Bo is trying the roads:|Roads that Bo can drive:|\d+ of \d+|progressbar.*|Saving …|Saved|(?<=[?&]p=)[\w-]+/g
/** Two stations, a road, and a circle with a strange name. */
const strange = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1600 1000">
<circle id="node-0" cx="300" cy="500" r="40"/><circle id="node-1" cx="1200" cy="500" r="40"/>
<path id="path-0-1" d="M300 500L1200 500"/><path id="path-1-0" d="M1200 500L300 500"/><circle id="node-x" r="4"/></svg>`

/** Chooses a file where a button asks for one. */
async function gives(child: Child, button: Locator, name: string, content: Buffer | string) {
  const asked = child.page.waitForEvent('filechooser')
  await button.click()
  await (await asked).setFiles({ name, mimeType: '', buffer: Buffer.from(content) })
}

/** Empty paper, from home on. */
async function begins(child: Child) {
  await follows(child, 'home.maps')
  await child.presses('design.new')
  await expect(child.words('design.empty')).toBeVisible()
}

/** Pulls from a place to another one and holds. */
async function pulls(page: Page, from: Spot, to: Spot) {
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  await page.mouse.move(to.x, to.y, { steps: 4 })
}

const field = (child: Child, role: 'textbox' | 'spinbutton' | 'combobox' | 'checkbox', key: string) =>
  child.page.getByRole(role, { name: child.word(key), exact: true })

async function types(field: Locator, text: string) {
  await field.fill(text)
  await field.blur()
}

test('a map begins in every way that it can', { tag: '@map-designer' }, async ({ child, page }) => {
  const open = child.button('design.open')
  const opens = async () => {
    await gives(child, open, 'Two.svg', strange)
    await expect(child.words('design.openedWith')).toBeVisible()
  }
  await goesThrough(
    child,
    'map-designer-begins',
    {
      'the ways to begin': () => follows(child, 'home.maps'),
      'a file that is no drawing is refused': () => gives(child, open, 'a.svg', 'hello'),
      'a strange drawing is opened': opens,
      'a drawing that is too large is refused': async () => {
        await gives(child, open, 'a.svg', ' '.repeat(2_000_001))
        await expect(child.words('design.tooLarge')).toBeVisible()
      },
      'a disk without room keeps nothing': async () => {
        await refusesToKeep(page, true)
        await child.presses('design.new')
        await expect(child.words('design.notKept')).toBeVisible()
      },
      'a strange drawing is opened again': async () => {
        await refusesToKeep(page, false)
        await opens()
      },
      'it is drawn on': () => child.presses('design.drawOn'),
      'a dead end of one way': async () => {
        await child.button('design.road', { from: 0, to: 1 }).focus()
        await child.presses('design.bothWays')
      },
      'the other maps, with this one': () => child.presses('design.others'),
      'its own map is opened': () => page.getByRole('link', { name: 'Two', exact: true }).click(),
      'a map of everybody is drawn on': async () => {
        await child.presses('design.others')
        await page.locator('main li button').nth(1).click()
        await expect(child.button('design.station', { station: 2 })).toBeVisible()
      },
      'its way back to empty rooms': async () => {
        await child.presses('design.others')
        await child.presses('rooms.new')
      },
      'a map that this device has not': async () => {
        // By address: a link from another device.
        await page.goto('/maps?p=nowhere&m=map')
        await expect(child.words('design.missing')).toBeVisible()
      },
    },
    { hides },
  )
})

/** Steps about stations, on empty paper. */
function stationSteps(child: Child, maker: MapMaker): Steps {
  const { page } = child
  const presses = async (across: number, down: number) => {
    const { x, y } = await maker.place(across, down)
    await page.mouse.click(x, y)
  }
  /** Focus chooses a station, unless it has the focus already. */
  const chosen = async (station: number) => {
    await maker.station(station).blur()
    await maker.station(station).focus()
  }
  return {
    'empty paper': () => begins(child),
    'one station': () => presses(0.15, 0.7),
    'two stations': () => presses(0.5, 0.25),
    'three stations': () => presses(0.85, 0.7),
    'nothing is chosen': async () => {
      await maker.takes('road', (tool) => tool.click())
      await presses(0.5, 0.9)
    },
    'a road is pulled': async () => pulls(page, await maker.place(0.15, 0.7), await maker.place(0.4, 0.4)),
    'the pull is broken off': async () => {
      const paper = page.getByRole('group', { name: child.word('design.paper'), exact: true })
      await paper.dispatchEvent('pointercancel')
      await page.mouse.up()
      await presses(0.5, 0.9)
      await chosen(1)
    },
    'a road is pulled to its end': async () =>
      child.drags(await maker.place(0.15, 0.7), await maker.place(0.5, 0.25)),
    'a road by keys begins': async () => {
      await chosen(1)
      await child.types('Enter')
    },
    'a road by keys ends': async () => {
      await chosen(2)
      await child.types('Enter')
    },
    'the last station is the goal': async () => {
      await chosen(2)
      await child.presses('design.goalHere')
      await maker.seesReached(2)
      await maker.seesTried(2, 2)
      const bar = page.getByRole('progressbar', { name: child.word('design.tried'), exact: true })
      await expect(bar).toHaveAttribute('value', '2')
      await expect(bar).toHaveAttribute('max', '2')
      await expect(page.getByText(child.word('design.tried'))).toBeVisible()
    },
    'another goal as well': async () => {
      await chosen(1)
      await child.presses('design.alsoGoal')
    },
    'it is no goal any more': () => child.presses('design.noGoal'),
    'the goal is the start': async () => {
      await chosen(2)
      await child.presses('design.startHere')
    },
    'taken back by keys': async () => {
      await chosen(1)
      await child.types('ControlOrMeta+z')
    },
    'done again': () => child.presses('design.redo'),
    'taken back': () => child.presses('design.undo'),
    'a station has a name and a reward': async () => {
      await chosen(1)
      await types(field(child, 'textbox', 'design.name'), ' Mill ')
      await types(field(child, 'spinbutton', 'design.reward'), '-5')
    },
    'the list': () => child.presses('design.asList'),
    'a station is chosen in the list': () =>
      page.getByRole('listitem').getByRole('button', { name: 'Station 2' }).click(),
    'a road is chosen in the list': () =>
      page.getByRole('listitem').getByRole('button', { name: 'Road 1 – 2' }).click(),
    'a station is added in the list': () => child.presses('design.addStation'),
    'from the third': () => field(child, 'combobox', 'design.from').selectOption('3'),
    'no road leads from a station to itself': () => field(child, 'combobox', 'design.to').selectOption('3'),
    'a road is added': async () => {
      await field(child, 'combobox', 'design.to').selectOption('2')
      await child.presses('design.addRoad')
    },
    'the answers': () => child.presses('design.asAnswers'),
    'a station is moved by keys': async () => {
      await chosen(3)
      await child.types('ArrowRight', 'Shift+ArrowDown')
    },
    'a station is pulled': async () => {
      await maker.takes('station', (tool) => tool.click())
      const from = await child.middleOf(maker.station(3))
      await child.drags(from, { x: from.x + 60, y: from.y + 40 })
    },
    'a station is removed by keys': async () => {
      await chosen(3)
      await child.types('Delete')
    },
    'a station is removed': async () => {
      await chosen(0)
      await child.presses('design.remove')
    },
  }
}

test('stations of a map, step by step', { tag: '@map-designer' }, async ({ child }) => {
  await goesThrough(child, 'map-designer-stations', stationSteps(child, new MapMaker(child)), {
    hides,
  })
})

/** Steps about rooms, and the bar above every map. */
function roomSteps(child: Child): Steps {
  const { page } = child
  const room = (number: number) => page.getByRole('button', { name: new RegExp(`^Room ${number},`) })
  const makes = (kind: string, number: number) => async () => {
    const kinds = page.getByRole('region', { name: child.word('rooms.tools') })
    await kinds.getByRole('button', { name: child.word(`rooms.kind.${kind}`), exact: true }).click()
    await room(number).click()
  }
  const saves = async () => {
    const downloads = page.waitForEvent('download')
    await child.presses('design.saveSvg')
    expect((await downloads).suggestedFilename()).toBe('Den.svg')
  }
  const shares = async () => {
    await child.presses('design.share')
    await expect(page.getByRole('dialog')).toBeVisible()
    await child.types('Escape')
    await expect(page.getByRole('dialog')).toHaveCount(0)
  }
  return {
    'empty rooms': async () => {
      await follows(child, 'home.maps')
      await child.presses('rooms.new')
    },
    'a wall': makes('wall', 2),
    'a trap': makes('trap', 3),
    ice: makes('ice', 4),
    wind: makes('wind', 5),
    'more wind': () => room(5).click(),
    'another treasure': makes('treasure', 8),
    'the start is elsewhere': makes('start', 7),
    'floor again': makes('floor', 3),
    'the start stays': () => room(7).click(),
    'the next room is changed by keys': async () => {
      await makes('trap', 9)()
      await child.types('ArrowRight', 'Enter')
      await expect(room(10)).toHaveAttribute('tabindex', '0')
      await expect(room(9)).toHaveAttribute('tabindex', '-1')
      await expect(room(10)).toBeFocused()
    },
    'taken back by keys': () => child.types('ControlOrMeta+z'),
    'done again': () => child.presses('design.redo'),
    'taken back': () => child.presses('design.undo'),
    'two rooms across': () => field(child, 'combobox', 'rooms.columns').selectOption('2'),
    'two rooms down': () => field(child, 'combobox', 'rooms.rows').selectOption('2'),
    'a treasure beside the start': makes('treasure', 3),
    'the treasure stays': makes('wall', 3),
    'no way to the treasure': async () => {
      await room(1).click()
      await room(2).click()
    },
    'its name is taken back': async () => {
      await types(field(child, 'textbox', 'design.mapName'), 'Den')
      await saves()
      await shares()
      await child.presses('design.undo')
    },
    'a way again': () => child.presses('design.undo'),
    'the papers': () => child.presses('design.print'),
    'no paper': () => child.dialog('design.printTitle').getByRole('button').first().click(),
    'the papers again': () => child.presses('design.print'),
    'no paper by keys': () => child.types('Escape'),
    'on A3': async () => {
      await page.evaluate(() => (window.print = () => (document.title = 'printed')))
      await child.presses('design.print')
      await child.presses('design.paper_a3')
      await expect(page).toHaveTitle('printed')
      await page.emulateMedia({ media: 'print' })
      await expect(page.locator('.printed-map.a3 tr')).toHaveCount(9)
    },
    'on the screen': () => page.emulateMedia({ media: 'screen' }),
    'a disk without room keeps nothing': async () => {
      await refusesToKeep(page, true)
      await child.presses('design.learn')
      await expect(child.words('design.notKept')).toBeVisible()
      await refusesToKeep(page, false)
      await child.seesSaved()
    },
    'Bo learns in the rooms': async () => {
      await child.presses('design.learn')
      await new Learner(child).sees()
      await child.seesLab()
    },
  }
}

test('rooms of a map, step by step', { tag: '@map-designer' }, async ({ child }) => {
  await goesThrough(child, 'map-designer-rooms', roomSteps(child), { hides })
})

/** Steps about roads and the whole map, on two stations with a road. */
function roadSteps(child: Child, maker: MapMaker): Steps {
  const { page } = child
  const tool = (name: 'station' | 'road' | 'sign' | 'reward') => maker.takes(name, (one) => one.click())
  const drags = async (...[a, b, c, d]: readonly [number, number, number, number]) =>
    child.drags(await maker.place(a, b), await maker.place(c, d))
  const presses = async (across: number, down: number) => {
    const { x, y } = await maker.place(across, down)
    await page.mouse.click(x, y)
  }
  const look = (name: string) => child.button(`design.dresses.${name}`)
  return {
    'four stations': async () => {
      await begins(child)
      for (const [across, down] of [
        [0.15, 0.2],
        [0.85, 0.8],
        [0.15, 0.8],
        [0.85, 0.2],
      ] as const)
        await presses(across, down)
      await expect(maker.station(3)).toBeVisible()
    },
    'two roads cross': async () => {
      await tool('road')
      await drags(0.15, 0.2, 0.85, 0.8)
      await drags(0.15, 0.8, 0.85, 0.2)
    },
    'a circle, and a dead end': async () => {
      await drags(0.15, 0.2, 0.15, 0.8)
      await drags(0.85, 0.2, 0.15, 0.2)
    },
    'a bend that is too tight': () => drags(0.15, 0.5, 0.3, 0.24),
    'it is taken out': () => child.presses('design.straighten'),
    'a wide bend': () => drags(0.5, 0.2, 0.5, 0.06),
    'the bend is pulled, and the road leads one way': async () => {
      const bend = page.locator('.frame .handle').first()
      const before = (await bend.getAttribute('cx'))!
      await drags(0.5, 0.06, 0.6, 0.08)
      await expect(bend).not.toHaveAttribute('cx', before)
      await child.presses('design.bothWays')
    },
    'it is closed': () => field(child, 'combobox', 'design.sign').selectOption('both'),
    'it leads the other way': () => page.getByRole('button', { name: /^only / }).click(),
    'both ways again': () => page.getByRole('button', { name: /^only / }).click(),
    'only one way is closed': () => field(child, 'combobox', 'design.sign').selectOption('there'),
    'only the other way is closed': () => field(child, 'combobox', 'design.sign').selectOption('back'),
    'it is slippery and pays': async () => {
      await field(child, 'combobox', 'design.slip').selectOption('0.2')
      await types(field(child, 'spinbutton', 'design.reward'), '7')
    },
    'a road is chosen by its focus, and removed': async () => {
      await maker.road(0, 2).focus()
      await child.presses('design.remove')
    },
    'a road is removed by keys': async () => {
      await maker.road(2, 3).focus()
      await child.types('Backspace')
    },
    'a sign by a press': async () => {
      await tool('sign')
      await presses(0.4, 0.414)
    },
    'a station out of reach': async () => {
      await tool('station')
      await presses(0.5, 0.9)
    },
    'what counts on the whole map': async () => {
      await tool('reward')
      await presses(0.3, 0.9)
    },
    'each move costs, and its length': async () => {
      await types(field(child, 'spinbutton', 'design.moveCost'), '3')
      await field(child, 'checkbox', 'design.lengthCounts').check()
    },
    'a try goes on': () => field(child, 'checkbox', 'design.goesOn').check(),
    ...Object.fromEntries(
      ['town', 'railway', 'mars', 'sea', 'paper', 'meadow'].map((name) => [
        `the look of ${name}`,
        () => look(name).click(),
      ]),
    ),
    'it is covered by fog': () => field(child, 'combobox', 'design.cover').selectOption('fog'),
    'it is covered by nothing': () => field(child, 'combobox', 'design.cover').selectOption(''),
    'on paper': () => page.emulateMedia({ media: 'print' }),
    'on the screen': () => page.emulateMedia({ media: 'screen' }),
    'a file that is no picture is refused': () => gives(child, look('photo'), 'a.png', 'hello'),
    'a photo lies below': async () => {
      await gives(child, look('photo'), 'a.png', picture(16, 10))
      await expect(look('photo')).toHaveAttribute('aria-pressed', 'true')
      await expect(page.locator('input[type=file]')).toHaveAttribute(
        'aria-label',
        child.word('design.dresses.photo'),
      )
    },
  }
}

test('roads and looks of a map, step by step', { tag: '@map-designer' }, async ({ child }) => {
  await goesThrough(child, 'map-designer-roads', roadSteps(child, new MapMaker(child)), { hides })
})
