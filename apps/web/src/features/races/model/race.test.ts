import { heatsOf, resultOf, runLane, type Lane, type Race } from '@botgarten/experiments/race'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { workersHere } from '#lab/testing/worker.ts'
import { choices, laneOf, settingsOf } from './lanes.ts'
import { RaceModel } from './race.svelte.ts'
import { Runners } from './runners.ts'
import { trackOn } from './testing/track.ts'
import type { Tried } from './walked.ts'

let model: RaceModel
let workers: ReturnType<typeof workersHere>
beforeEach(() => {
  screen()
  workers = workersHere(() => import('./worker.ts'))
  model = new RaceModel(trackOn('cliff'))
  Object.assign(model, { criterion: 'stars', tries: 6, runs: 5 })
})
afterEach(() => {
  model.close()
  vi.unstubAllGlobals()
})

const racers = () => model.runners.map(({ racer }) => racer)
const tried: Tried = { states: [0, 1], stars: 3, falls: 2, atGoal: false }
const me = { racer: 'me', tries: [tried, tried] } as const
/** The same race run lane by lane, without workers. */
const inTurn = (race: Race) =>
  race.lanes.map((_, lane) => {
    const runs = Array.from({ length: race.runs }, (_, run) => runLane(race, lane + 1, run + 1))
    return resultOf(runs, race.tries)
  })

describe('a race', () => {
  test('needs something that wins before it starts', async () => {
    model.criterion = null
    await model.start()
    expect([model.last, model.share]).toEqual([null, null])
  })

  test('has the results that one worker alone would have, and its winner has the most stars', async () => {
    await model.start()
    const { race, results, winners, order, points, criterion } = model.last!
    expect(results).toEqual(inTurn(race))
    const stars = results.map(({ bill }) => bill.stars)
    expect(stars[winners[0]!]).toBe(Math.max(...stars))
    expect(order.map((lane) => stars[lane])).toEqual(stars.toSorted((a, b) => b - a))
    expect([points.at(-1), criterion, model.share, model.playback.atEnd]).toEqual([6, 'stars', null, true])
    expect(workers.map(({ isOver }) => isOver)).toEqual([true, true])
  })

  test('throws other dice the next time, and cannot start twice at once', async () => {
    await Promise.all([model.start(), model.start()])
    expect([model.seed, workers.length]).toEqual([1, 2])
    await model.start()
    expect([model.seed, model.last!.race.seed]).toEqual([2, 2])
  })

  test('with a child has as many tries as the child walked, and its lane in its place', async () => {
    model.change(1, me)
    expect([model.triesOfAll, model.me]).toEqual([2, me])
    await model.start()
    const { race, results, runners } = model.last!
    expect([race.tries, race.lanes.length, results.length]).toEqual([2, 3, 4])
    expect(results[1]!.bill).toMatchObject({ stars: 6, falls: 4 })
    expect(results[2]).toEqual(inTurn(race)[1])
    expect(runners[1]).toBe(me)
  })
})

describe('the lanes of a race', () => {
  test('are two to eight', () => {
    while (!model.isFull) model.add(laneOf('q'))
    expect(racers()).toHaveLength(8)
    model.add(laneOf('random'))
    expect([racers().length, racers().at(-1)]).toEqual([8, 'random'])
    for (let more = 0; more < 8; more += 1) model.drop(0)
    expect([racers().length, model.canDrop]).toEqual([2, false])
  })

  test('have a child at most once: walked again it takes its own place', () => {
    model.add(me)
    const again = { racer: 'me', tries: [tried] } as const
    model.add(again)
    expect([racers(), model.triesOfAll]).toEqual([['q', 'sarsa', 'best', 'random', 'me'], 1])
    model.drop(4)
    expect([model.me, model.triesOfAll]).toEqual([undefined, 6])
    model.drop(1)
    expect(racers()).toEqual(['q', 'best', 'random'])
  })

  test('are set with the values of the blocks; who has no choice between old and new has no rho', () => {
    const { alpha, gamma, nu, rho } = choices
    const lane = laneOf('q')
    for (const [setting, all] of [
      ['alpha', alpha],
      ['gamma', gamma],
      ['nu', nu],
      ['rho', rho],
    ] as const)
      // prettier-ignore
      expect(all.map(({ value }) => value)).toContain(lane[setting])
    expect(settingsOf('sarsa')).toContain('rho')
    expect([settingsOf('best'), settingsOf('random')].flat()).not.toContain('rho')
  })
})

test('workers share the heats of a race: the share that is done grows to 1', async () => {
  const lanes: readonly Lane[] = [laneOf('q'), laneOf('sarsa')]
  const race: Race = { task: trackOn('cliff').task, lanes, tries: 3, runs: 12, seed: 4 }
  const shares: number[] = []
  const runners = new Runners()
  expect(await runners.run(race, (share) => shares.push(share))).toEqual(inTurn(race))
  expect(shares).toEqual(shares.toSorted((a, b) => a - b))
  expect([shares.length, shares.at(-1)]).toEqual([[...heatsOf(race)].length, 1])
  runners.close()
})
