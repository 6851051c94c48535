import { mapField } from '@botgarten/blocks'
import { Learner, learningProject } from '../child-learning.ts'
import type { Child } from '../child.ts'
import { expect, opensProject, test } from '../gate/gate.ts'
import { goesThrough, type Steps } from '../steps.ts'

test.use({ language: 'en' })

/** How far Bo came before it was stopped. */
const hides = /The next one is [\d.]+ c?m away/g

const box = (child: Child, key: string) => child.page.getByLabel(child.word(key), { exact: true })
const list = (child: Child, key: string) =>
  child.page.getByRole('combobox', { name: child.word(key), exact: true })
const level = (name: 'starter' | 'explorer' | 'expert') => (child: Child) =>
  list(child, 'q.level').selectOption(name)

const pointsAway = ({ page }: Child) => page.mouse.move(2, 2)

async function types(child: Child, key: string, text: string) {
  await box(child, key).fill(text)
  await box(child, key).press('Enter')
}

const cell = (child: Child, from: number, to: number) =>
  child.page.getByRole('button', { name: child.word('q.cell', { from, to, value: 0, tries: 0 }) })

/** Stations, roads and rewards of a map, and the settings of the learner. */
const choosing: Steps = {
  'the railway': async (child) => {
    await new Learner(child).opens('railway')
    await pointsAway(child)
  },
  'a number is pointed at': (child) => cell(child, 3, 5).hover(),
  'nothing is pointed at': pointsAway,
  'a number has the focus': (child) => cell(child, 3, 5).focus(),
  'it has it no longer': (child) => cell(child, 3, 5).blur(),
  'a road is pointed at': (child) => new Learner(child).road(2, 3).hover(),
  'the first station has the focus': async (child) => {
    await pointsAway(child)
    await new Learner(child).station(0).focus()
  },
  'an arrow leads to the last road': (child) => child.types('ArrowLeft'),
  'a road is tapped': (child) => new Learner(child).road(2, 3).click(),
  'Escape closes its choices': (child) => child.types('Escape'),
  'a station is chosen by Enter': async (child) => {
    await new Learner(child).station(4).focus()
    await child.types('Enter')
  },
  'its choices are closed': (child) => child.presses('q.close'),
  'the learning starts elsewhere': (child) => new Learner(child).makesStation(4, 'startHere'),
  'it ends elsewhere': (child) => new Learner(child).makesStation(5, 'goalHere'),
  'start, goal and map can be changed': (child) => child.presses('q.change'),
  // Within the frame in which the editor reports the first change.
  'start and goal are changed in lists': async (child) => {
    await list(child, 'q.start').selectOption('3')
    await list(child, 'q.goal').selectOption('1')
  },
  'numbers for explorers': async (child) => {
    await child.presses('q.close')
    await level('explorer')(child)
  },
  'a station can pay': (child) => new Learner(child).station(4).click(),
  'a station pays': (child) => types(child, 'q.pay.here', '2.5'),
  'more than 50 is not taken': async (child) => {
    await types(child, 'q.pay.here', '51')
    await expect(box(child, 'q.pay.here')).toHaveValue('2.5')
    await child.presses('q.close')
  },
  'a road costs': async (child) => {
    await new Learner(child).road(4, 5).click()
    await types(child, 'q.pay.here', '-3')
  },
  'both pay nothing': async (child) => {
    await types(child, 'q.pay.here', '0')
    await new Learner(child).station(4).click()
    await types(child, 'q.pay.here', '0')
    await child.presses('q.close')
  },
  'length counts': (child) => box(child, 'q.pay.length').check(),
  'each move costs': async (child) => {
    await box(child, 'q.pay.length').uncheck()
    await types(child, 'q.pay.step', '2')
  },
  'numbers for experts': async (child) => {
    await types(child, 'q.pay.step', '0')
    await level('expert')(child)
  },
  'parameters are typed and chosen': async (child) => {
    await types(child, 'q.parameter.alpha', '0.3')
    await types(child, 'q.parameter.nu', '0.2')
    await child.page
      .getByRole('combobox', { name: child.word('q.falls', { parameter: 'α' }) })
      .selectOption('0.9')
    await list(child, 'q.rules').selectOption('study')
  },
  'a road is closed in one direction': async (child) => {
    await new Learner(child).road(2, 3).click()
    await child.presses('q.closeOne', { from: 2, to: 3 })
  },
  'a closed road can be opened': (child) => new Learner(child).road(2, 3).click(),
  'a road is closed in both directions': (child) => child.presses('q.closeRoad'),
  'no road leads to the goal': async (child) => {
    await new Learner(child).closes(0, 1)
    await new Learner(child).closes(1, 2)
  },
  'nothing can be guessed': (child) => new Learner(child).turnsTo('trials'),
  'there are no curves yet': (child) => new Learner(child).turnsTo('curves'),
  'the program is unfolded': (child) => child.page.locator('button.folded').click(),
}

const seesMoves = (child: Child, made: number) =>
  expect.poll(async () => (await new Learner(child).moves()).made).toBe(made)

const learnsToTheEnd = async (child: Child) => {
  await new Learner(child).hurries()
  await new Learner(child).learns()
}

/** As it is printed: the dialog of the browser would stop the page. */
async function prints(child: Child) {
  await child.page.evaluate(() => (window.print = () => (document.title = 'printed')))
  await child.presses('q.print')
  await expect(child.page).toHaveTitle('printed')
}

/** A guess, a run of learning, each page about it, and the drive. */
const learning: Steps = {
  'the railway with a closed road': async (child) => {
    await new Learner(child).opens('railway')
    await new Learner(child).closes(2, 3)
    await pointsAway(child)
  },
  'time stands still while Bo rides': async (child) => {
    await child.page.clock.install()
    await child.page.clock.pauseAt(Date.now() + 60_000)
    await new Learner(child).learns()
    await child.page.clock.runFor(500)
  },
  'the ride is paused': (child) => child.presses('q.pause'),
  'a hand stops the learning': async (child) => {
    await child.page.clock.resume()
    await child.presses('q.stop')
  },
  'one move of another learning': async (child) => {
    await child.presses('q.again')
    await new Learner(child).hurries()
    await child.presses('q.step')
    await seesMoves(child, 1)
  },
  'its sum for explorers': level('explorer'),
  'its formula for experts': level('expert'),
  'the same dice again': (child) => child.presses('q.again'),
  'a guess begins': async (child) => {
    await level('starter')(child)
    await child.presses('q.guessing.open')
  },
  'a way is guessed': async (child) => {
    for (const station of [4, 5]) await new Learner(child).station(station).click()
  },
  'the last station is taken back': (child) => child.presses('q.guessing.undo'),
  'the guess is taken back': (child) => child.presses('q.guessing.clear'),
  'the guess leads nowhere': async (child) => {
    for (const station of [5, 0, 1]) await new Learner(child).station(station).click()
    await child.presses('q.guessing.undo')
    await new Learner(child).station(1).click()
  },
  'Bo learns beside the guess': async (child) => {
    await child.presses('q.guessing.clear')
    for (const station of [4, 5, 0, 1]) await new Learner(child).station(station).click()
    await child.presses('q.guessing.learn')
    await expect(child.words('q.compare.shorter', { count: 1 })).toBeVisible()
  },
  'what Bo has learned': (child) => child.presses('q.inside'),
  trials: (child) => new Learner(child).turnsTo('trials'),
  'trials with numbers': async (child) => {
    await level('expert')(child)
    await prints(child)
    expect(await new Learner(child).savesTable()).toContain('3-5-0-1')
  },
  'trials on paper': ({ page }) => page.emulateMedia({ media: 'print' }),
  'the same dice have the same result': async (child) => {
    await child.page.emulateMedia({ media: 'screen' })
    await child.presses('q.again')
    await expect(child.page.locator('.drawer tbody tr')).toHaveCount(3)
    await expect(child.button('q.letDrive')).toBeVisible()
  },
  curves: (child) => new Learner(child).turnsTo('curves'),
  'a race on the same map': async (child) => {
    await child.presses('q.race')
    await expect(child.button('race.start')).toBeVisible()
  },
  'a race against Bo': async (child) => {
    await child.page.goBack()
    await new Learner(child).sees()
    await new Learner(child).turnsTo('curves')
    await child.presses('q.againstBo')
    await expect(child.words('race.tryOf', { now: 1, count: 3 })).toBeVisible()
  },
  'back to the map': async (child) => {
    await child.page.goBack()
    await new Learner(child).sees()
  },
  'trials are thrown away': async (child) => {
    await new Learner(child).turnsTo('trials')
    await child.presses('q.clear')
  },
  'Bo drives': async (child) => {
    await new Learner(child).turnsTo('inside')
    await child.presses('q.letDrive')
    await child.pressesStop()
  },
  'why it drives there, with stars': level('starter'),
  'the map in front': (child) => child.page.locator('button.map').click(),
  'the floor in front': (child) => child.presses('q.largeFloor'),
  'the map in front again': (child) => child.presses('q.largeMap'),
  'another guess': (child) => child.presses('q.guessing.again'),
  'Bo learns without a guess': async (child) => {
    await child.presses('q.guessing.without')
    await new Learner(child).hurries()
    await expect(new Learner(child).floor).toBeVisible()
    await child.pressesStop()
  },
  'back to the first move': async (child) => {
    await child.presses('q.largeMap')
    await new Learner(child).timeline.press('Home')
    await new Learner(child).timeline.press('ArrowRight')
  },
}

const room = (child: Child, room: number) => child.button('q.room', { room })
const chooses = (map: string) => (child: Child) =>
  new Learner(child).choosesMap(child.word(`choice.${mapField(map)}`))

/** Maps of another kind: rooms in which moves are by chance, and a map that is nearly square. */
const otherMaps: Steps = {
  'the railway': async (child) => {
    await new Learner(child).opens('railway')
    await pointsAway(child)
  },
  'the lake': chooses('lake'),
  'a room is tapped': (child) => room(child, 5).click(),
  'Bo has learned on the lake': async (child) => {
    await child.presses('q.close')
    await learnsToTheEnd(child)
    await new Learner(child).seesEnd()
  },
  'a room that Bo knows': (child) => room(child, 8).click(),
  'its values': level('explorer'),
  'the learning starts in it': async (child) => child.presses('q.startHere'),
  'the city': async (child) => {
    const city = { MAP: 'MAP_CITY', START: '0', FINISH: '15' }
    await new Learner(child).opensProject('City', learningProject('City', city, 300))
    await level('starter')(child)
  },
  'one move in the city': async (child) => {
    await new Learner(child).hurries()
    await child.presses('q.step')
    await seesMoves(child, 1)
  },
  'its sum is opened': (child) => child.presses('q.sum'),
  'how its number came about': async (child) => {
    await child.presses('q.sum')
    await child.presses('proof.sign')
  },
  'less room for the city': async (child) => {
    await child.types('Escape')
    await child.page.setViewportSize({ width: 1180, height: 820 })
  },
  'Bo drives through the city, faster': async (child) => {
    await new Learner(child).learns()
    await child.presses('q.driveFaster', { speed: 4 })
    await child.pressesStop()
  },
  'the map in front again': (child) => child.presses('q.largeMap'),
  'another map is drawn': async (child) => {
    await child.presses('q.change')
    await child.presses('q.drawMap')
    await expect(child.page).toHaveURL(/\/maps\?p=/)
  },
}

/** Less and less room: tabs over the map, a phone, and a phone on its side. */
const small: Steps = {
  'a tablet with tabs': async (child) => {
    await child.page.setViewportSize({ width: 800, height: 700 })
    await new Learner(child).opens('railway')
    await new Learner(child).closes(2, 3)
    await pointsAway(child)
  },
  'numbers in the place of the map': (child) => new Learner(child).turnsTo('inside'),
  'a guess in the place of the numbers': async (child) => {
    await child.presses('q.guessing.open')
    for (const station of [4, 5, 0, 1]) await new Learner(child).station(station).click()
  },
  'what Bo has learned beside the guess': async (child) => {
    await child.presses('q.guessing.learn')
    await new Learner(child).turnsTo('map')
    await new Learner(child).hurries()
    await expect(child.words('q.compare.shorter', { count: 1 })).toBeVisible()
  },
  'the tablet on its end': ({ page }) => page.setViewportSize({ width: 768, height: 1024 }),
  'a phone': ({ page }) => page.setViewportSize({ width: 390, height: 844 }),
  'another learning on the phone': (child) => child.presses('q.playNew'),
  'a road is tapped on the phone': (child) => new Learner(child).road(2, 3).click(),
  'it is open again': (child) => child.presses('q.openRoad'),
  'a guess on the phone': async (child) => {
    await child.presses('q.guessing.open')
    for (const station of [4, 5]) await new Learner(child).station(station).click()
  },
  'the guess leads nowhere on the phone': async (child) => {
    await child.presses('q.guessing.clear')
    for (const station of [2, 1]) await new Learner(child).station(station).click()
  },
  'the last station is taken back': (child) => child.presses('q.guessing.undo'),
  'Bo learns on the phone': async (child) => {
    await child.presses('q.guessing.without')
    await child.pressesStop()
  },
  'the way on the phone': (child) => child.presses('lab.learningTab'),
  'numbers on the phone': (child) => new Learner(child).turnsTo('inside'),
  'the phone on its side': ({ page }) => page.setViewportSize({ width: 900, height: 500 }),
}

/** Programs that lack something. */
const lacking: Steps = {
  'a start that is not on the map': async (child) => {
    await child.opensHome()
    await child.opensFileAtHome('Lost.botgarten.json', learningProject('Lost', { START: '9' }))
    await expect(child.words('q.noStation')).toBeVisible()
  },
  'a program without what Bo learns by': async (child) => {
    await opensProject(child, 'Bare', bare('Bare'))
    await level('expert')(child)
  },
}

/** The railway's program without the block that sets the learner. */
const bare = (name: string) =>
  JSON.stringify(JSON.parse(learningProject(name, {})), (_, value: unknown) =>
    Array.isArray(value) ? value.filter((one: { id?: string } | null) => one?.id !== 'behaviour') : value,
  )

test('a map is chosen, changed and paid', { tag: '@q-learning' }, ({ child }) =>
  goesThrough(child, 'q-learning-choosing', choosing, { hides }),
)

test('Bo learns beside a guess and drives what it has learned', { tag: '@q-learning' }, ({ child }) =>
  goesThrough(child, 'q-learning', learning, { hides }),
)

test('rooms, and a map that is nearly square', { tag: '@q-learning' }, ({ child }) =>
  goesThrough(child, 'q-learning-maps', otherMaps, { hides }),
)

test('a map on small screens', { tag: '@q-learning' }, ({ child }) =>
  goesThrough(child, 'q-learning-small', small, { hides }),
)

test('programs that lack something', { tag: '@q-learning' }, ({ child }) =>
  goesThrough(child, 'q-learning-lacking', lacking, { hides }),
)
