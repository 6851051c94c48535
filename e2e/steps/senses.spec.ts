import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { TryHands } from '../child-trying.ts'
import type { Child } from '../child.ts'
import { expect, opensCard, opensProject, test } from '../gate/gate.ts'
import { goesThrough, type Steps } from '../steps.ts'

test.use({ language: 'en' })

/** The length of a run and the last bump depend on the speed of the machine. */
const hides =
  /[\d.]+ seconds? ago|of [\d.]+ s\b|(?<=slider "Moment of the run": ).*|(?<=paragraph: )Bo (bumped|stands|drives).*|(?<=valuemax: )\d+\.\d/g

const edge = (child: Child) => new TryHands(child).edgeOnRay('left', 'farFrom')

const trying: Steps = {
  'nothing is tried': (child) => new TryHands(child).opensSolution(),
  'near and far': (child) => child.presses('senses.edges'),
  'an edge is typed': async (child) => {
    await new TryHands(child).typedEdge('left', 'nearBelow').fill('22')
    await child.types('Enter')
  },
  'no number is not taken, an edge is pushed by keys': async (child) => {
    await new TryHands(child).typedEdge('left', 'nearBelow').fill('much')
    await child.types('Enter')
    await expect(new TryHands(child).typedEdge('left', 'nearBelow')).toHaveValue('22')
    await new TryHands(child).edgeOnRay('right', 'farFrom').focus()
    await child.types('PageUp')
  },
  'an edge is pulled': async (child) => {
    const { x, y } = await child.middleOf(edge(child))
    await child.drags({ x, y }, { x: x - 20, y: y - 20 })
  },
  'each was one step': async (child) => {
    for (let steps = 0; steps < 3; steps += 1) await child.presses('lab.undo')
  },
  'an edge is pushed and left': async (child) => {
    await edge(child).focus()
    await child.types('PageUp')
    await edge(child).blur()
    await child.presses('lab.undo')
    await child.presses('senses.edges')
    await new TryHands(child).cell(0, 0).click()
  },
  'the cell below': (child) => child.types('ArrowDown'),
  'the cell at its right': (child) => child.types('ArrowRight'),
  'none is looked at': (child) => child.presses('senses.followLast'),
  'Bo has tried for ten seconds': async (child) => {
    const { time } = new TryHands(child)
    await child.pressesStart()
    await time.opens()
    await time.chooses('16')
    await time.runsUntil(12)
    await time.goesBack('Home')
    for (let second = 0; second < 10; second += 1) await child.types('Shift+ArrowRight')
  },
  'a cell that was tried': async (child) => {
    const bo = new TryHands(child)
    const tried = (await bo.numbers()).findIndex((text) => text.trim() !== '·')
    await bo.cell(Math.floor(tried / 3), tried % 3).click()
  },
  'how its number came about': (child) => new TryHands(child).proof.asks(),
}

/** A project in which Bo has learned a night of eight minutes. */
function nightProject(learned: boolean): string {
  const { card, world } = content.card('try-dodge')!
  const { tables, ...program } = content.program('try-dodge', 'solution')!
  const curve = Array.from({ length: 8 }, (_, minute) => ({ pay: minute * 4 - 8, bumps: 8 - minute }))
  const project = cardProject(world, card, program, 'Night')
  return JSON.stringify(learned ? { ...project, tables: { try: { ...tables!['try']!, curve } } } : project)
}

const places = (child: Child) =>
  child.page.getByRole('checkbox', { name: child.word('night.places', { count: 3 }) })

const night: Steps = {
  'the card': (child) => opensCard(child, 'try-dodge'),
  'what was learned in a night': (child) => opensProject(child, 'Night', nightProject(true)),
  'there is nothing to do': (child) => child.presses('night.begin'),
  'a cell beside the curves': (child) => new TryHands(child).cell(2, 1).click(),
  'nothing is learned': (child) => opensProject(child, 'Night', nightProject(false)),
  'each try begins at any place': (child) => places(child).check(),
  'and at one place again': (child) => places(child).uncheck(),
  'a night without its script': async (child) => {
    await child.page.route(/\/night-worker[^/]*\.js$/, () => {})
    await child.presses('night.begin')
    const bar = child.page.getByRole('progressbar', { name: child.word('night.asleep') })
    await expect(bar).toHaveAttribute('max', /^\d+$/)
    await expect(bar).toHaveAttribute('value', '0')
  },
  'it is stopped': async (child) => {
    await child.presses('night.stop')
    await child.page.unroute(/\/night-worker[^/]*\.js$/)
  },
}

test('a table fills by trying, step by step', { tag: '@senses' }, ({ child }) =>
  goesThrough(child, 'senses', trying, { hides }),
)

test('a night of learning, step by step', { tag: '@senses' }, ({ child }) =>
  goesThrough(child, 'senses-night', night),
)
