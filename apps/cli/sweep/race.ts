import {
  criteria,
  criteriaOn,
  limits,
  orderOf,
  pointsOf,
  winnersOf,
  type Criterion,
  type LaneResult,
  type Race,
} from '@botgarten/experiments/race'
import { raceInThreads } from '@botgarten/experiments/race/threads'
import type { Task } from '@botgarten/learning/q-learning'
import type { Command } from '../commands.ts'
import { CallError } from '../errors.ts'
import { seedOf, taskOf } from '../learn-options.ts'
import { findMap } from '../maps.ts'
import { oneOf, options, refuseMore, wholeNumberIn } from '../options.ts'
import { message } from '../words.ts'
import { lanesIn } from './lanes.ts'
import { threadsIn } from './sweep.ts'
import { tell } from './table.ts'

const known = {
  start: { type: 'string' },
  goal: { type: 'string' },
  closed: { type: 'string' },
  'goal-reward': { type: 'string' },
  'step-cost': { type: 'string' },
  'length-cost': { type: 'string' },
  lanes: { type: 'string' },
  criterion: { type: 'string' },
  tries: { type: 'string' },
  runs: { type: 'string' },
  seed: { type: 'string' },
  'same-dice': { type: 'boolean' },
  threads: { type: 'string' },
  json: { type: 'boolean' },
} as const

/** `botgarten learn q-race MAP …`: two to eight learners on one map, many runs each, on all cores. */
export const race: Command = { options: known, execute: raceAll }

async function raceAll(args: string[]): Promise<string> {
  const { values, positionals } = options(args, known)
  const [what, ...more] = positionals
  if (what === undefined) throw new CallError('call.raceWhat')
  refuseMore(more)
  const task = taskOf(findMap(what), values)
  const race: Race = {
    ...{ task, lanes: lanesIn(values.lanes), seed: seedOf(values) },
    tries: wholeNumberIn('tries', values.tries, 100, 1, limits.tries),
    runs: wholeNumberIn('runs', values.runs, 20, 1, limits.runs),
    sameDice: values['same-dice'] === true,
  }
  const criterion = criterionOf(task, values.criterion)
  const lanes = await raceInThreads(race, threadsIn(values.threads), tell)
  return values.json ? JSON.stringify(reportOf(what, race, criterion, lanes)) : said(race, criterion, lanes)
}

/** The first that can count on this map, or the one that is asked for. */
function criterionOf(task: Task, text: string | undefined): Criterion {
  const offered = criteriaOn(task)
  const asked = text === undefined ? offered[0]! : oneOf('criterion', text, criteria)
  if (!offered.includes(asked)) throw new CallError('call.criterion', { asked, names: offered.join(', ') })
  return asked
}

function reportOf(map: string, race: Race, criterion: Criterion, lanes: readonly LaneResult[]) {
  const { task, tries, runs, seed, sameDice } = race
  const bills = lanes.map(({ bill }) => bill)
  return {
    ...{ map, start: task.start, goal: task.goal, tries, runs, seed, sameDice, criterion },
    winners: winnersOf(bills, criterion).map((lane) => lane + 1),
    points: pointsOf(tries),
    lanes: lanes.map(({ bill, ways, curves }, index) => ({
      ...{ lane: index + 1, ...race.lanes[index], bill, ways: ways.at(-1), curves },
    })),
  }
}

function said(race: Race, criterion: Criterion, lanes: readonly LaneResult[]): string {
  const bills = lanes.map(({ bill }) => bill)
  const winners = winnersOf(bills, criterion)
  const lines = orderOf(bills, criterion).map((lane) => {
    const { racer, rho } = race.lanes[lane]!
    const { moves, stars, falls, first, found, reaches } = bills[lane]!
    const name = racer === 'q' || racer === 'sarsa' ? `${racer} (rho ${rho})` : racer
    const way = reaches === null ? wayOf(first, found, race.runs) : reachesOf(reaches)
    const mark = winners.includes(lane) ? '*' : ' '
    return `${mark} ${lane + 1}. ${message('race.lane', { name, moves, stars, falls, way })}`
  })
  const { tries, runs } = race
  return [message(`race.head.${criterion}`, { tries, runs }), ...lines].join('\n')
}

const wayOf = (first: number | null, found: number, runs: number) =>
  first === null ? message('race.noWay', { found, runs }) : message('race.way', { first, found, runs })

const reachesOf = (share: number) => message('race.getsThere', { percent: (100 * share).toFixed(1) })
