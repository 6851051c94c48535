// Tries every card against runs that do not solve it. The results are listed in benchmarks/results/praise.md, and
// praise.slow.test.ts compares them.
import { cardDocument, type CardProgram } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { createLab, type Document } from '@botgarten/lab'
import { courseOf, withLearnedWay } from '@botgarten/maps'
import { check, learningIn, tryingIn, type Program } from '@botgarten/programs'
import type { Pose } from '@botgarten/simulation'
import reached from './reached.json' with { type: 'json' }

/** Each attempt, described for the list. */
const attempts = {
  start: 'only Start',
  untouched: 'no run',
  before: 'the solution of the card before',
  moved: 'its own solution, from a place moved by hand',
} as const
type Attempt = keyof typeof attempts

/** Result of an attempt over all start places and all learned ways. */
export interface Outcome {
  readonly card: string
  readonly attempt: Attempt
  /** Why the program does not run on this card; null if it runs. */
  readonly unfit: string | null
  /** By goal: in how many runs it was green at some moment. */
  readonly green: ReadonlyMap<string, number>
  readonly runs: number
  /** In how many runs all goals were green at once. */
  readonly all: number
}

export const cardIds = content.cards.map(({ id }) => id)

/** Seeds with which a way is learned: 100 of them find every way with a probability above a few percent. */
const SEEDS = 100

const mainOf = ({ programs }: CardProgram): Program => programs['main']!

/** Simulated seconds after which nothing more can come. */
function secondsFor(id: string, program: CardProgram): number {
  const { playground, checks } = content.card(id)!.card
  const drives = playground === 'q-learning' ? 180 : 60
  const tries = 60 * (tryingIn(mainOf(program))?.minutes ?? 0)
  return tries + Math.max(drives, ...checks.map(({ seconds }) => seconds + 10))
}

/** A card's world with its way learned and drawn, once for each way that the seeds lead to. */
function* learnedIn(document: Document): Generator<Document> {
  const outline = learningIn(document.programs['main']!)
  if (!outline) {
    yield document
    return
  }
  const map = content.mapFile(outline.map)!
  const ways = new Set<string>()
  for (let seed = 1; seed <= SEEDS; seed++) {
    const course = courseOf(outline, map, seed)
    course.advance(outline.moves)
    const way = String(course.way().states)
    if (!ways.has(way)) yield withLearnedWay(document, content.mapFile, seed)
    ways.add(way)
  }
}

/** Goals that are green at some moment of a run, and whether all are at once, as a screen sees it in each tick. */
function run(id: string, document: Document, seconds: number) {
  const { checks } = content.card(id)!.card
  const lab = createLab()
  const floor = content.floorOf(document.world)
  lab.load(document, floor, { seed: 1, checks })
  if (seconds > 0) lab.start()
  const green = new Set<string>()
  for (;;) {
    const passed = lab.view().checks.filter((one) => one.passed)
    for (const goal of passed) green.add(goal.id)
    const all = passed.length === checks.length
    if (all || lab.now().phase !== 'running' || lab.view().seconds >= seconds) return { green, all }
    lab.advance(1)
  }
}

/** Every place and way of one attempt. */
function outcomeOf(
  card: string,
  attempt: Attempt,
  program: CardProgram,
  seconds: number,
  by?: Pose,
): Outcome {
  const { card: data, world } = content.card(card)!
  const [stops] = check(mainOf(program), world.robots[0]!.config).filter((finding) => finding.stops)
  const unfit = stops ? `does not fit: ${stops.problem}` : null
  const results = (unfit === null ? data.starts : []).flatMap((_, start) =>
    Array.from(learnedIn(cardDocument(world, data, program, start)), (document) =>
      run(card, moved(document, by), seconds),
    ),
  )
  const green = new Map(
    data.checks.flatMap(({ id }): [string, number][] => {
      const count = results.filter((one) => one.green.has(id)).length
      return count > 0 ? [[id, count]] : []
    }),
  )
  return { card, attempt, unfit, green, runs: results.length, all: results.filter(({ all }) => all).length }
}

/** The first robot moved by so much. */
function moved(document: Document, by: Pose = { x: 0, y: 0, heading: 0 }): Document {
  const [robot, ...others] = document.world.robots
  const { x, y, heading } = robot!.pose
  const pose = { x: x + by.x, y: y + by.y, heading: heading + by.heading }
  return { ...document, world: { ...document.world, robots: [{ ...robot!, pose }, ...others] } }
}

/** So little that the solution still holds from there. */
export const byHand: Pose = { x: 1, y: 0.5, heading: 1 }

/** The card before this one in its bed. */
function cardBefore(id: string): string | null {
  const { bed } = content.cards.find((one) => one.id === id)!
  const inBed = content.cards.filter((one) => one.bed === bed).map((one) => one.id)
  return inBed[inBed.indexOf(id) - 1] ?? null
}

/** All attempts on a card. */
export function outcomesOf(card: string): readonly Outcome[] {
  const [start, solution] = ['start', 'solution'].map((file) => content.program(card, file)!)
  const before = cardBefore(card)
  const other = before === null ? null : content.program(before, 'solution')!
  return [
    outcomeOf(card, 'start', start!, secondsFor(card, start!)),
    outcomeOf(card, 'untouched', start!, 0),
    ...(other ? [outcomeOf(card, 'before', other, secondsFor(card, other))] : []),
    outcomeOf(card, 'moved', solution!, secondsFor(card, solution!), byHand),
  ]
}

/** Is the solution of the card before this card's own? Then it is the work that the card asks for. */
export function isSameSolution(card: string): boolean {
  const before = cardBefore(card)
  return (
    before !== null &&
    JSON.stringify(content.program(before, 'solution')) === JSON.stringify(content.program(card, 'solution'))
  )
}

/** Why a goal may turn green although the card is not solved; undefined if there is no reason on record. */
export const reasonFor = (card: string, goal: string): string | undefined =>
  (reached as { readonly [cardAndGoal: string]: string })[`${card} ${goal}`]

/** Every reason, as card and goal. */
export const reasons = Object.keys(reached)

/** Is an attempt praised? A run from a place moved by hand never counts, which praise.slow.test.ts checks in the lab. */
function praiseOf({ card, attempt, all }: Outcome): string {
  if (all === 0) return 'no'
  if (attempt === 'moved') return 'no: the run does not count'
  return attempt === 'before' && isSameSolution(card) ? 'yes: it is the solution of this card, too' : 'yes'
}

function rowOf(outcome: Outcome): string {
  const { card, attempt, unfit, green, runs } = outcome
  const attempted = attempt === 'before' ? `${attempts.before}, \`${cardBefore(card)!}\`` : attempts[attempt]
  const goals = [...green].map(([goal, count]) => `${goal} (${count})`).join(', ')
  const why = attempt === 'moved' ? [] : [...green.keys()].map((goal) => reasonFor(card, goal) ?? '?')
  return `| ${[card, attempted, unfit ?? runs, goals || '–', praiseOf(outcome), [...new Set(why)].join(' ')].join(' | ')} |`
}

/** The list as Markdown. */
export const listOf = (outcomes: readonly Outcome[]): string => `# Praise

For each card: which goals turn green, in how many of the runs, and whether the card is praised. One run for each start place and, where Bo learns a way, for each way that ${SEEDS} seeds lead to. A goal is green as soon as it is true of the run, a card is praised when all are at once. Written by \`npm run --silent test:unit -- apps/web/src/app/lab-screen/praise --update\`.

| card | attempt | runs | green goals | praised | why a goal may be green |
| --- | --- | --: | --- | --- | --- |
${outcomes.map(rowOf).join('\n')}
`
