import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { outcomeOf } from '@botgarten/experiments'
import { finish, laneKinds, race, summariesOf } from '@botgarten/experiments/brain-race'
import { raceOf, winnersOf, type Bill, type Criterion, type Racer } from '@botgarten/experiments/race'
import { createLab } from '@botgarten/lab'
import { courseOf, isShortest } from '@botgarten/maps'
import { learningIn } from '@botgarten/programs'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { expect } from 'vitest'
import { content } from '../files.ts'
import { cardDocument, type CardProgram } from '../index.ts'
import { blocksIn } from '../items/blocksIn.ts'
import type { BrainsClaim, Claim, DriveClaim, LearnClaim, RaceClaim } from '../schema/planTypes.ts'
import { givenFor } from './given.ts'
import { practisedBy } from './practise-claims.ts'
import { paidSays, rowsSay, triedSays } from './sense-claims.ts'

addBlocks(learning)
addBlocks(expert)

/** A claim as the name of its test, and the claim. */
export const named = (claim: Claim) => [nameOf(claim), claim] as const

function nameOf(claim: Claim): string {
  if ('card' in claim) return `Bo on ${claim.card} from place ${claim.place}: ${claim.passed}`
  if ('learns' in claim)
    return `${claim.found} of ${claim.of} Bos on ${claim.learns} after ${claim.tries} tries`
  if ('practises' in claim) return `practice of ${claim.practises}: ${JSON.stringify(claim)}`
  if ('course' in claim) return `brains race on ${claim.course}`
  if ('run' in claim) return `${Object.values(claim.run).join(' ')}: ${claim.answer}`
  if ('cage' in claim) return `${claim.cheating} Bos in the cage ${claim.cage}`
  if ('trying' in claim) return `Bo tries on ${claim.trying}: drives after ${claim.passes} minutes`
  if ('ahead' in claim) return `only ahead in ${claim.ahead}: ${JSON.stringify(claim.coins)}`
  return `${claim.race.racers.join(' against ')} on ${claim.race.map}: ${claim.wins.join(', ')}`
}

/** Makes the run that a claim speaks of. */
export function expectTrue(claim: Claim): void {
  if ('card' in claim) expect(secondOf(claim)).toBe(claim.passed)
  else if ('learns' in claim) expect(shortestOf(claim)).toBe(claim.found)
  else if ('practises' in claim) expect(claim).toMatchObject(practisedBy(claim))
  else if ('run' in claim) expect(outcomeOf(claim.run, givenFor(claim.run))).toBe(claim.answer)
  else if ('course' in claim) expect(drivenBy(claim)).toEqual(claim.lanes)
  else if ('cage' in claim) expect(rowsSay(claim)).toEqual(claim)
  else if ('trying' in claim) expect({ trying: claim.trying, ...triedSays(claim) }).toEqual(claim)
  else if ('ahead' in claim) expect(paidSays(claim)).toEqual(claim.coins)
  else expect(raced(claim)).toEqual({ wins: claim.wins, bills: claim.bills })
}

/** A card's program as the claim has it. */
function programOf({ card, weights, file = 'solution', numbers = {} }: DriveClaim): CardProgram {
  const program = structuredClone(content.program(card, file)!)
  for (const block of blocksIn(program) as readonly { id: string; fields: Record<string, string> }[])
    if (block.id in numbers) block.fields['NUM'] = String(numbers[block.id])
  const brains = Object.entries(program.brains).map(
    ([name, brain]) => [name, { ...brain, ...(weights && { weights }) }] as const,
  )
  return { ...program, brains: Object.fromEntries(brains) }
}

/** The second in which all checks of a card have passed; null: its time, a minute, or what the claim says, is not enough. */
function secondOf(claim: DriveClaim): number | null {
  const { card, world } = content.card(claim.card)!
  const lab = createLab()
  const document = cardDocument(world, card, programOf(claim), claim.place - 1)
  lab.load(document, content.floorOf(world), { seed: 1, checks: card.checks })
  lab.start()
  const seconds = Math.max(60, (claim.passed ?? 0) + 1, ...card.checks.map((check) => check.seconds))
  for (let second = 1; second <= seconds; second++) {
    lab.advance(TICKS_PER_SECOND)
    if (lab.view().checks.every(({ passed }) => passed)) return second
  }
  return null
}

/** How many of these Bos know a shortest way. */
function shortestOf({ learns, tries, of, settings = {} }: LearnClaim): number {
  const { programs } = content.program(learns, 'solution')!
  const outline = Object.values(programs).flatMap((program) => learningIn(program) ?? [])[0]!
  const asked = { ...outline, episodes: tries, settings: { ...outline.settings, ...settings } }
  const map = content.mapFile(outline.map)!
  const seeds = Array.from({ length: of }, (_, at) => at + 1)
  return seeds.filter((seed) => {
    const course = courseOf(asked, map, seed)
    course.advance(asked.moves)
    const { states } = course.way()
    return states !== null && isShortest(course, states)
  }).length
}

/** The race with the settings that the page of races begins with. */
function raced({ race: { map: id, racers, criterion, ...race }, bills }: RaceClaim) {
  const { map, start = 0, goal = map.actions.length - 1, goalReward, stepCost } = content.mapFile(id)!
  const task = { map, start, goal, ...definedOf({ goalReward, stepCost }) }
  const lanes = racers.map((racer) => ({ racer: racer as Racer, alpha: 0.5, gamma: 0.8, nu: 0, rho: 0.1 }))
  const found = raceOf({ ...race, task, lanes }).map(({ bill }) => bill)
  const columns = (name: string) =>
    Object.keys(bills[name]!).map((column) => [column, found[racers.indexOf(name)]![column as keyof Bill]])
  return {
    wins: winnersOf(found, criterion as Criterion).map((lane) => racers[lane]),
    bills: Object.fromEntries(Object.keys(bills).map((name) => [name, Object.fromEntries(columns(name))])),
  }
}

/** The race as a page begins it. */
function drivenBy({ course: id, lanes }: BrainsClaim): BrainsClaim['lanes'] {
  const course = content.courses.find((one) => one.id === id)!
  const world = content.world(course.world)!
  const racing = laneKinds.map((kind) => ({ kind, racer: content.racer(id, kind) }))
  const results = finish(race({ course, world, floor: content.floorOf(world) }, racing, 1))
  const driven = summariesOf(results, racing).flatMap((one) =>
    one && one.kind in lanes ? [[one.kind, { cm: Math.round(one.cm), bumps: one.bumps }] as const] : [],
  )
  return Object.fromEntries(driven)
}

const definedOf = <T extends object>(all: T) =>
  Object.fromEntries(Object.entries(all).filter(([, value]) => value !== undefined))
