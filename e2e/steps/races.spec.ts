import { mapField } from '@botgarten/blocks'
import type { Locator } from '@playwright/test'
import { readFile } from 'node:fs/promises'
import { racesFour } from '../child-racing.ts'
import type { Child } from '../child.ts'
import { expect, follows, opensCard, test } from '../gate/gate.ts'
import { goesThrough, type Steps } from '../steps.ts'

/** A class that is gone is refused. */
const complaints = [/status of 40\d/]

test.use({ language: 'en', complaints })

const radio = (child: Child, key: string) => child.page.getByRole('radio', { name: child.word(key) })
const list = (child: Child, key: string) =>
  child.page.getByRole('combobox', { name: child.word(key), exact: true })
/** A learner of the race, by its number from 0. */
const lane = ({ page }: Child, at: number): Locator => page.locator('.set li > button').nth(at)
const timeline = (child: Child) => child.page.getByRole('slider', { name: child.word('race.timeline') })

async function races(child: Child) {
  await child.button('race.start').or(child.button('race.again')).click()
  await expect(child.button('race.again')).toBeEnabled()
}

/** As it is printed: the dialog of the browser would stop the page. */
async function prints(child: Child, key: string) {
  await child.page.evaluate(() => {
    window.print = () => document.body.classList.add('printed')
  })
  await child.presses(key)
  await expect(child.page.locator('body')).toHaveClass(/printed/)
}

async function choosesMap(child: Child, map: string) {
  await child.presses('race.map')
  const name = child.word(`choice.${mapField(map)}`)
  await child.page.getByRole('dialog').getByRole('button', { name, exact: true }).click()
  await expect(child.page).toHaveURL(new RegExp(`map=${map}`))
}

const learners: Steps = {
  'the races': (child) => follows(child, 'home.race'),
  'a criterion is chosen': (child) => radio(child, 'race.criterion.falls').check(),
  'four learners race': races,
  'why their ways differ': (child) => child.presses('race.whyOther'),
  'the first try': async (child) => {
    await child.presses('race.whyOther')
    await timeline(child).press('Home')
  },
  'the next one': (child) => child.presses('race.next'),
  'the curves as a table': (child) => child.presses('race.table'),
  'time stands still while the race is shown': async (child) => {
    await child.presses('race.table')
    await prints(child, 'race.print')
    await child.page.clock.install()
    await child.page.clock.pauseAt(Date.now() + 60_000)
    await child.presses('race.times', { speed: 3 })
    await child.presses('race.replay')
  },
  'it is held': (child) => child.presses('race.pause'),
  'another criterion': async (child) => {
    await child.page.clock.resume()
    await radio(child, 'race.criterion.way').check()
  },
  'what the second learner is set to': (child) => lane(child, 1).click(),
  'it learns otherwise': async (child) => {
    await list(child, 'race.kind').selectOption('best')
    await list(child, 'race.setting.alpha').selectOption({ index: 0 })
  },
  'it leaves the race': (child) => child.presses('race.drop'),
  'the first one is opened and closed': async (child) => {
    await lane(child, 0).click()
    await lane(child, 0).click()
    await child.presses('race.learner')
  },
  'eight learners are all': async (child) => {
    for (let count = 5; count <= 8; count += 1) await child.presses('race.learner')
  },
  'two learners are the fewest': async (child) => {
    for (let count = 8; count > 2; count -= 1) {
      if (count < 8) await lane(child, 0).click()
      await child.presses('race.drop')
    }
    await lane(child, 0).click()
  },
  'a short race with the same dice': async (child) => {
    await list(child, 'race.tries').selectOption('10')
    await list(child, 'race.runs').selectOption('1')
    await child.page.getByRole('checkbox', { name: child.word('race.sameDice') }).check()
    await races(child)
  },
  'all maps': (child) => child.presses('race.map'),
  'none is chosen': (child) => child.presses('race.close'),
  'Escape closes them, too': async (child) => {
    await child.presses('race.map')
    await child.types('Escape')
    await choosesMap(child, 'lake')
  },
  'learners race where moves are by chance': async (child) => {
    await radio(child, 'race.criterion.stars').check()
    await list(child, 'race.tries').selectOption('10')
    await list(child, 'race.runs').selectOption('5')
    await races(child)
  },
  'no such map': async (child) => {
    await child.page.goto('/race?map=nowhere')
    await expect(child.page.getByRole('alert')).toBeVisible()
  },
}

const through = async (child: Child, ...rooms: readonly number[]) => {
  for (const room of rooms)
    await child.page
      .getByRole('button', { name: new RegExp(`^${child.word('race.doorTo')} ${room} `) })
      .click()
}
/** Through a door of a room of a grid. */
const goes = (child: Child, side: string) =>
  child.page
    .locator('.room')
    .getByRole('button', { name: new RegExp(child.word(`race.sides.${side}`)) })
    .click()

const walking: Steps = {
  'the races': (child) => follows(child, 'home.race'),
  'a child walks on the cliff': (child) => child.presses('race.toYou'),
  'it goes up': (child) => goes(child, 'up'),
  'it falls': async (child) => {
    await goes(child, 'down')
    await goes(child, 'right')
  },
  'the railway': (child) => choosesMap(child, 'railway'),
  'through a door': (child) => through(child, 5),
  'its door gets stars': (child) => child.presses('race.stars', { count: 3 }),
  'another door is asked about': async (child) => {
    await through(child, 3)
    await child.page.locator('.notes .row button').first().click()
  },
  'it starts again': (child) => child.presses('race.startAgain'),
  'both ways after three tries': async (child) => {
    for (let round = 0; round < 3; round += 1) {
      await through(child, 5)
      await child.presses('race.stars', { count: round + 1 })
      await through(child, 0, 1)
      if (round < 2) await child.presses('race.nextTry', { number: round + 2 })
    }
    await prints(child, 'race.print')
  },
  'Bo goes on': async (child) => {
    await child.presses('race.letGoOn', { count: 20 })
    await expect(child.page.getByText(child.word('race.boWay', { way: '3 → 5 → 0 → 1' }))).toBeVisible()
  },
  'an answer is written': (child) => child.page.getByLabel(child.word('race.whatDid')).fill('5 → 0'),
  'it races with what it walked': (child) => child.presses('race.raceWithMe'),
  'it has raced': async (child) => {
    await radio(child, 'race.criterion.way').check()
    await races(child)
  },
  'what it is set to': (child) => lane(child, 4).click(),
  'back to its walk': (child) => child.presses('race.addMe'),
  'the race is still there': async (child) => {
    await child.presses('race.toRace')
    await child.presses('race.toYou')
    await child.presses('race.playAgain')
  },
}

const moment = (child: Child) => child.page.getByRole('slider', { name: child.word('race.brains.moment') })

const brains: Steps = {
  'four brains, from their card': async (child) => {
    await opensCard(child, 'four-brains')
    await child.presses('lab.raceBrains')
    await expect(child.button('race.brains.ready')).toBeVisible()
  },
  'a shorter course': async (child) => {
    await list(child, 'race.brains.course').selectOption('friendship')
    await expect(child.page).toHaveURL(/brains=friendship/)
  },
  'a lane has another brain': (child) => child.page.getByRole('combobox').last().selectOption({ index: 0 }),
  'the bill': racesFour,
  'the bill on paper and as a file': async (child) => {
    await prints(child, 'race.brains.print')
    const [download] = await Promise.all([
      child.page.waitForEvent('download'),
      child.presses('race.brains.csv'),
    ])
    expect(await readFile(await download.path(), 'utf8')).toContain(',')
    await child.presses('race.brains.startNumber', { number: 3 })
  },
  'the first moment': (child) => moment(child).press('Home'),
  'time stands still while they drive': async (child) => {
    await child.page.clock.install()
    await child.page.clock.pauseAt(Date.now() + 60_000)
    await child.presses('race.brains.watch')
    await child.presses('race.times', { speed: 3 })
  },
  'they are held': (child) => child.presses('race.pause'),
  'a question is answered': async (child) => {
    await child.page.clock.resume()
    await child.page.getByRole('radio').first().check()
  },
  'both are': (child) => child.page.getByRole('radio').last().check(),
  'the brains again': (child) => child.presses('race.brains.toLanes'),
  'the bill again': (child) => child.presses('race.brains.toBill'),
  'a class that is gone': async (child) => {
    await child.page.goto('/race?brains=garden&class=nobody')
    await expect(child.words('race.brains.noClass')).toBeVisible()
  },
  'without a project': (child) => child.page.goto('/race?brains=garden'),
}

test('races of learners, step by step', { tag: '@races' }, ({ child }) =>
  goesThrough(child, 'races', learners),
)

test('a child walks, and races with Bo', { tag: '@races' }, ({ child }) =>
  goesThrough(child, 'races-walking', walking),
)

test('a race of brains, step by step', { tag: '@races' }, ({ child }) =>
  goesThrough(child, 'races-brains', brains, { hides: /(?<=[?&](?:p|class)=)[\w-]+/g }),
)
