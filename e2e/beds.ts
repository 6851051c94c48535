import { content } from '@botgarten/content/files'
import { expect } from '@playwright/test'
import { colourInput, knobOf, node } from './child-cards.ts'
import { Learner } from './child-learning.ts'
import { SortingHands } from './child-sorting.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child, type Motor, type Sensor } from './child.ts'
import { fixesDice } from './navigation.ts'
import { finds, type Way } from './ways.ts'

/** A card, and what a child does to solve it. */
interface Task {
  readonly card: string
  readonly solve: (child: Child, way: Way) => Promise<void>
}

const light: Sensor = { sensor: 'light', port: '1', place: 'front' }

const turns = (child: Child, way: Way, from: Sensor, to: Motor, weight: number) =>
  way.turn(child.knob(from, to), child.output(to), weight)

async function friendship(child: Child, way: Way) {
  await turns(child, way, leftEye, leftWheel, 0.8)
  await turns(child, way, rightEye, rightWheel, 0.8)
}

/** Adds a neuron by the plus of the network. */
async function adds(child: Child, way: Way, layer: 'addSensor' | 'addMotor' | 'addOutput', name: string) {
  await way.press(child.plus(layer))
  await way.press(child.offered.and(child.page.getByRole('button', { name, exact: true })))
}

async function incognito(child: Child, way: Way) {
  await adds(child, way, 'addMotor', child.nameOf(rightWheel))
  await turns(child, way, light, leftWheel, 0.6)
  await turns(child, way, light, rightWheel, 0.6)
}

const leaves = [
  ['green', 'green'],
  ['yellow', 'orange'],
  ['red', 'red'],
] as const

async function chameleon(child: Child, way: Way) {
  const lamp = (colour: string) => child.word('neuron.lamp', { OUTPUTNODE: child.word(`choice.${colour}`) })
  for (const [colour, shines] of leaves.slice(1)) {
    await adds(child, way, 'addSensor', colourInput(child, 'colour', colour))
    await adds(child, way, 'addOutput', lamp(shines))
  }
  for (const [colour, shines] of leaves) {
    const [from, to] = [colourInput(child, 'colour', colour), lamp(shines)]
    await way.turn(knobOf(child, from, to), node(child, 'showSum', to), 1)
  }
}

/** Gives Bo more tries: the program lies over the map meanwhile. */
async function givesTries(child: Child, way: Way, now: string, tries: string) {
  await way.press(child.button('lab.unfold').first())
  await child.seesBlocks()
  await way.type(child.block('experience'), now, tries)
  await way.press(child.button('lab.fold').first())
}

async function closes(child: Child, way: Way, from: number, to: number) {
  const learner = new Learner(child)
  await way.press(learner.road(from, to))
  await way.press(child.button('q.closeRoad'))
  await learner.seesClosedRoads(2)
}

const mars = (child: Child, way: Way) => givesTries(child, way, '1', '100')

async function railway(child: Child, way: Way) {
  await closes(child, way, 2, 3)
  await givesTries(child, way, '10', '100')
}

async function forest(child: Child, way: Way) {
  await closes(child, way, 4, 6)
  await givesTries(child, way, '10', '300')
}

/** What a child types to find a block. */
const searched = {
  en: { find: 'find', drive: 'drive', forever: 'forever', show: 'show', group: 'group of', call: 'call' },
  de: {
    find: 'finde',
    drive: 'fahre',
    forever: 'für immer',
    show: 'zeige',
    group: 'Gruppe dieser',
    call: 'nenne',
  },
}

async function tidyUp(child: Child, way: Way) {
  const words = searched[child.language]
  const [forth, back] = ['forward', 'backward'].map((one) => child.word(`choice.${one}`))
  await way.choose(child.block('b7'))
  await finds(child, way, words.find, 'ai_sorting_find')
  const drive = await finds(child, way, words.drive, 'robActions_motorDiff_on')
  await way.pick(drive, forth!, back!)
  await way.choose(drive)
  await finds(child, way, words.forever, 'robControls_loopForever')
  await finds(child, way, words.show, 'robActions_display_text')
  await finds(child, way, words.group, 'ai_sorting_group')
}

async function newColours(child: Child, way: Way) {
  const words = searched[child.language]
  await way.choose(child.block('b9'))
  for (const [number, name] of ['Iris', 'Aqua', 'Kiwi'].entries()) {
    const called = await finds(child, way, words.call, 'ai_sorting_name')
    if (number > 0) await way.type(called, '1', String(number + 1))
    await way.type(called, '', name)
    await way.choose(called)
  }
}

/** The first three cards of each bed, in the order in which they get harder; the first stands for its bed. */
const beds: { readonly [bed: string]: readonly Task[] } = {
  network: [
    { card: 'friendship', solve: friendship },
    { card: 'incognito', solve: incognito },
    { card: 'chameleon', solve: chameleon },
  ],
  'q-learning': [
    { card: 'mars', solve: mars },
    { card: 'railway', solve: railway },
    { card: 'forest', solve: forest },
  ],
  sorting: [
    { card: 'tidy-up', solve: tidyUp },
    { card: 'new-colours', solve: newColours },
  ],
}

export const isLong = process.env['BOTGARTEN_LONG'] === '1'
/** One of each bed; all where time does not count. */
export const tasks = Object.values(beds).flatMap((all) => (isLong ? all : all.slice(0, 1)))
/** By keys the first card of the first bed is solved, from home on, by keyboard.spec.ts. */
export const tasksByKeys = isLong ? tasks : tasks.slice(1)

/** From home to the card, solved by hand, and driven from every place to the end; back at home its dots are full. */
export async function walks(child: Child, way: Way, { card: id, solve }: Task) {
  const { card } = content.card(id)!
  const learns = card.playground === 'q-learning'
  await child.opensHome()
  if (learns) await fixesDice(child)
  await way.press(child.page.locator(`a[href$="/lab/${id}"]`).first())
  await child.seesLab()
  await solve(child, way)
  await drives(child, way, card, learns)
  await child.seesSaved()
  await child.opensHome()
  const of = card.starts.length
  const full = child.word('home.level', { passed: of, of })
  const own = child.page.getByRole('listitem').filter({ has: child.page.locator(`a[href$="/lab/${id}"]`) })
  await expect(own.getByRole('img', { name: full, exact: true })).toBeVisible()
}

async function drives(
  child: Child,
  way: Way,
  { id, starts, checks }: { id: string; starts: readonly unknown[]; checks: readonly { id: string }[] },
  learns: boolean,
) {
  if (learns) await way.press(child.button('q.turbo'))
  await way.press(child.button('lab.start').first())
  if (learns) await new Learner(child).seesEnd()
  await way.hurry()
  for (let place = 1; place <= starts.length; place += 1) {
    await expect(child.words('lab.successTitle').first()).toBeVisible({ timeout: 120_000 })
    for (const check of checks) await child.seesCheck(id, check.id)
    if (place < starts.length) await way.press(child.button('lab.successStart', { number: place + 1 }))
  }
}

/** The bed of sorting begins without a robot: things are sorted, and their groups get names. */
export async function walksToVessels(child: Child, way: Way) {
  const sorting = new SortingHands(child)
  await child.opensHome()
  await way.press(child.page.locator('a[href$="/sorting"]').first())
  await expect(sorting.plane).toBeVisible()
  await way.press(child.button('sorting.play'))
  await sorting.seesDone()
}
