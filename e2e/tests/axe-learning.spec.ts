// Rooms: q-learning, training, senses, reward-zoo, races, sorting, map-designer, figures, learning, content
// axe in every state of a way of learning: by trying, from examples, by sorting, in the zoo and in races.
import { mapField } from '@botgarten/blocks'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { findsNothing, type States } from '../axe.ts'
import { Learner } from '../child-learning.ts'
import { MapMaker } from '../child-maps.ts'
import { ProofHands } from '../child-proof.ts'
import { racesFour } from '../child-racing.ts'
import { SenseVisitor } from '../child-sense-zoo.ts'
import { SortingHands, sortingProject } from '../child-sorting.ts'
import { TimeHands } from '../child-time.ts'
import { Teaching } from '../child-training.ts'
import { TryHands } from '../child-trying.ts'
import { ZooVisitor } from '../child-zoo.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'
import { languagesOf } from '../words.ts'

/** Questions on a map before Bo learns there. */
const onMaps: States = {
  'a road is tapped': async (child) => {
    const learner = new Learner(child)
    await learner.opens('railway')
    await learner.road(2, 3).click()
    await expect(child.button('q.closeRoad')).toBeVisible()
  },
  'a station is tapped': async (child) => {
    await child.types('Escape')
    await new Learner(child).station(2).click()
    await expect(child.button('q.startHere')).toBeVisible()
  },
  'a way is guessed': async (child) => {
    await child.types('Escape')
    const learner = new Learner(child)
    await learner.closes(2, 3)
    await learner.guesses(4, 5, 0)
    await expect(child.button('q.guessing.learn')).toHaveAttribute('aria-disabled', 'true')
  },
  'the guess beside what Bo has learned': async (child) => {
    const learner = new Learner(child)
    await learner.station(1).click()
    await child.presses('q.guessing.learn')
    await learner.hurries()
    await expect(child.words('q.compare.shorter', { count: 1 })).toBeVisible()
  },
}

/** Learning on a map: every page at every level. */
const levels: States = {
  'one move': async (child) => {
    await new Learner(child).opens('railway')
    await child.presses('q.step')
    await expect.poll(async () => (await new Learner(child).moves()).made).toBe(1)
  },
  'inside Bo for starters': async (child) => {
    const learner = new Learner(child)
    await learner.learnsToTheEnd()
    await child.presses('lab.stop')
    await learner.turnsTo('inside')
    await child.page.getByLabel(child.word('q.level')).selectOption('starter')
  },
  'inside Bo for experts': (child) => child.page.getByLabel(child.word('q.level')).selectOption('expert'),
  curves: async (child) => {
    await new Learner(child).turnsTo('curves')
    await expect(child.page.locator('.drawer figure')).toHaveCount(3)
  },
  trials: async (child) => {
    await new Learner(child).turnsTo('trials')
    await expect(child.page.locator('.drawer tbody tr')).toHaveCount(1)
  },
}

/** The same on a screen wide enough for start, goal and best way at the map's side. */
const withRoom: States = {
  'the forest': (child) => new Learner(child).opens('forest'),
  'all numbers after a move': async (child) => {
    await child.page.getByLabel(child.word('q.level')).selectOption('expert')
    await child.presses('q.step')
  },
  'start and goal are changed': (child) => child.presses('q.change'),
  'trials after learning': async (child) => {
    await child.types('Escape')
    const learner = new Learner(child)
    await learner.learnsToTheEnd()
    await learner.turnsTo('trials')
  },
  'inside Bo after learning': (child) => new Learner(child).turnsTo('inside'),
}

const rows = `eyeLeft,eyeRight,wheelLeft,wheelRight
40,40,45,45
39,59,25,60
100,53,65,25
`

const fromExamples: States = {
  'examples that were driven': async (child) => {
    const teaching = new Teaching(child)
    await child.opensLab('friendship')
    await teaching.shows()
    await teaching.remembers(45, 45)
    await teaching.chooses('drive')
    await teaching.drivesUntil(() => expect.poll(() => teaching.count()).toBeGreaterThan(4))
    await child.pressesStop()
  },
  'examples that were practised': async (child) => {
    const teaching = new Teaching(child)
    await teaching.opensFile('rows.csv', rows)
    await child.presses('training.onlyThese')
    await teaching.seesExamples(3)
    await teaching.letsPractise()
    await teaching.practises()
  },
  'how the error came about': (child) => new ProofHands(child).asks(),
}

/** A project in which Bo has learned a night of eight minutes. */
function nightProject(): string {
  const { card, world } = content.card('try-dodge')!
  const { tables, ...program } = content.program('try-dodge', 'solution')!
  const curve = Array.from({ length: 8 }, (_, minute) => ({ pay: minute * 4, bumps: 8 - minute }))
  const learned = { try: { ...tables!['try']!, curve } }
  return JSON.stringify({ ...cardProject(world, card, program, 'Night'), tables: learned })
}

const withSenses: States = {
  'nothing is tried yet': async (child) => {
    await child.opensLab('try-dodge')
    await new TryHands(child).sees()
  },
  'a cell of what was tried': async (child) => {
    const bo = new TryHands(child)
    await bo.opensSolution()
    await child.pressesStart()
    await bo.time.opens()
    await bo.time.chooses('16')
    await bo.time.runsUntil(20)
    const tried = (await bo.numbers()).findIndex((text) => text.trim() !== '·')
    await bo.cell(Math.floor(tried / 3), tried % 3).click()
  },
  'the curves of a night': async (child) => {
    await child.opensProject('Night', nightProject())
    const curves = child.page.getByRole('figure', { name: child.word('night.curves') })
    await expect(curves.getByRole('row')).toHaveCount(9)
  },
}

const fountain = content.cages.find(({ cage }) => cage.id === 'fountain')!
const spinner = content.senseCages.find(({ cage }) => cage.id === 'spinner')!

const zoo: States = {
  'a cheat, move by move': async (child) => {
    const visitor = new ZooVisitor(child)
    await visitor.comes()
    await visitor.enters(fountain)
    await visitor.guesses(fountain)
    await visitor.watches(fountain, 'never')
    await visitor.steps()
  },
  'all cages, one of them fixed': async (child) => {
    const visitor = new ZooVisitor(child)
    await visitor.mends(fountain)
    await visitor.seesMended(fountain)
    await visitor.leaves(1)
  },
  'a cheat with its own sensors': async (child) => {
    const visitor = new SenseVisitor(child)
    await visitor.comes()
    await visitor.enters(spinner)
    await visitor.guesses(spinner)
    await visitor.watches(spinner)
    await expect(child.page.locator('figure svg text')).toBeVisible()
  },
}

const races: States = {
  'learners have raced, with the table of their curve': async (child) => {
    await opensFromHome(child, 'home.race')
    await child.page.getByRole('radio', { name: child.word('race.criterion.falls') }).check()
    await child.presses('race.start')
    await expect(child.page.getByText(child.word('race.whyOther'))).toBeVisible()
    await child.presses('race.table')
    await expect(child.page.getByRole('table').nth(1)).toBeVisible()
  },
  'a child has walked and given stars': async (child) => {
    await opensFromHome(child, 'home.race')
    await child.presses('race.map')
    const railway = child.word(`choice.${mapField('railway')}`)
    await child.page.getByRole('dialog').getByRole('button', { name: railway, exact: true }).click()
    await expect(child.page.locator('.page-bar .title')).toHaveText(
      child.word('race.titleOn', { map: railway }),
    )
    await child.presses('race.toYou')
    await goesThrough(child, 5)
    await child.presses('race.stars', { count: 1 })
  },
  'both tables, after three walks': async (child) => {
    for (const room of [0, 1]) await goesThrough(child, room)
    for (const number of [2, 3]) {
      await child.presses('race.nextTry', { number })
      for (const room of [5, 0, 1]) await goesThrough(child, room)
    }
    await child.presses('race.letGoOn', { count: 20 })
    await expect(child.page.getByText(child.word('race.boWay', { way: '3 → 5 → 0 → 1' }))).toBeVisible()
  },
  'four brains before the race': async (child) => {
    await opensFromHome(child, 'home.race')
    await child.page.getByRole('link', { name: child.word('race.brains.title'), exact: true }).click()
    await expect(child.button('race.brains.startSealed', { number: 3 })).toBeVisible()
  },
  'four brains after it, at a moment of another start': async (child) => {
    await racesFour(child)
    await child.presses('race.brains.startNumber', { number: 4 })
    await child.page.getByRole('slider', { name: child.word('race.brains.moment') }).press('Home')
    await child.page.getByRole('radio').first().check()
  },
}

const goesThrough = (child: Child, room: number) =>
  child.page.getByRole('button', { name: new RegExp(`^${child.word('race.doorTo')} ${room} `) }).click()

const sortings = (['things', 'points', 'readings'] as const).map((source): States => ({
  [source]: async (child) => {
    const sorting = new SortingHands(child)
    await sorting.opens(source)
    if (source !== 'readings') await sorting.presses('join')
    if (source === 'points') await child.presses('lab.hint')
  },
}))
const sorting: States = {
  ...(Object.assign({}, ...sortings) as States),
  'what counts is guessed': async (child) => {
    const hands = new SortingHands(child)
    await hands.opens()
    await hands.presses('tab.things')
    await hands.presses('guess.open')
    await expect(child.dialog('sorting.guess.title')).toBeVisible()
  },
  'all is sorted': async (child) => {
    const hands = new SortingHands(child)
    await hands.opens()
    await hands.presses('play')
    await hands.seesDone()
  },
}

const collects = (card: 'tidy-up' | 'new-colours'): States => ({
  [`${card} is solved, what was collected beside it`]: async (child) => {
    await child.opensProjectAtHome('Mine', sortingProject(card, 'solution'))
    await child.pressesStart()
    await new TimeHands(child).hurries()
    await child.seesCheck(card, 'shows', true, 60_000)
    const collected = child.page.getByRole('region', { name: child.word('sorting.collected.title') })
    await expect(collected).toBeVisible()
  },
})

/** A card of each other bed, solved from its first place. */
const solved: States = {
  ...collects('tidy-up'),
  ...collects('new-colours'),
  'friendship is solved': async (child) => {
    await child.opensLab('friendship')
    await child.typesWeight(leftEye, leftWheel, 0.8)
    await child.typesWeight(rightEye, rightWheel, 0.8)
    await child.pressesStart()
    await new TimeHands(child).hurries()
    await expect(child.words('lab.successTitle').first()).toBeVisible({ timeout: 60_000 })
  },
  'mars is solved': async (child) => {
    const learner = new Learner(child)
    await learner.opens('mars')
    await learner.givesTries(100, 10_000, { tries: 1, time: 10_000 })
    await learner.hurries()
    await child.presses('lab.start')
    await learner.seesEnd()
    await new TimeHands(child).hurries()
    await expect(child.words('lab.successTitle').first()).toBeVisible({ timeout: 60_000 })
  },
  'home with cards that are done': async (child) => {
    await child.seesSaved()
    await child.opensHome()
    await expect(child.page.getByRole('img', { name: child.word('home.done') }).first()).toBeVisible()
  },
}

const designing: States = {
  'a map that Bo has tried': async (child) => {
    const maker = new MapMaker(child)
    await maker.begins((thing) => thing.click())
    await maker.draws()
  },
}

const walks = { onMaps, levels, withRoom, fromExamples, withSenses, zoo, races, solved, designing }

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`ways of learning, in ${language}`, () => {
    test.use({ language })
    for (const [name, states] of Object.entries(walks))
      test(`axe finds nothing: ${name}`, async ({ child }) => {
        test.setTimeout(240_000)
        await findsNothing(child, states)
      })
  })

  for (const viewport of [
    { width: 1366, height: 768 },
    { width: 390, height: 844 },
  ])
    test.describe(`sorting at ${viewport.width} × ${viewport.height}, in ${language}`, () => {
      test.use({ language, viewport })
      test('axe finds nothing', ({ child }) => findsNothing(child, sorting))
    })
}
