import { stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  createLearner,
  episodeLog,
  gridMap,
  layOutWorld,
  run,
  runEpisodes,
  saveLearner,
  step,
  type Settings,
} from './index.ts'

const share = fc.double({ min: 0, max: 1, noNaN: true })
const anySettings: fc.Arbitrary<Settings> = fc.record({
  rules: fc.constant('standard'),
  algorithm: fc.constantFrom('q', 'sarsa'),
  ...{ alpha: share, gamma: share, nu: share, rho: share },
})
const cliff = { ...gridMap(['FFFF', 'SCCG'], { cliffReward: -99 }), goalReward: 0, stepCost: 1 }
const lake = gridMap(['SFF', 'FHF', 'HFG'], { surefooted: 1 / 3 })
const worlds = [cliff, lake].map(layOutWorld)

const beginning = (world: (typeof worlds)[number], settings: Settings, seed: number) =>
  createLearner(world, settings, stream(seed, 'learn/test/1'))

describe('whole episodes', () => {
  test('are the same steps as one by one, written down as their traces add up', () => {
    fc.assert(
      fc.property(fc.constantFrom(...worlds), anySettings, fc.nat(), (world, settings, seed) => {
        const [ran, stepped] = [beginning(world, settings, seed), beginning(world, settings, seed)]
        const log = episodeLog(6)
        runEpisodes(ran, 2, log)
        runEpisodes(ran, 4, log)
        const sums = Array.from({ length: 6 }, () => ({ steps: 0, reward: 0, falls: 0 }))
        while (stepped.episodes < 6) {
          const { episode, reward, ends } = step(stepped)
          const one = sums[episode - 1]!
          one.steps++
          one.reward += reward
          // Nothing else costs so much.
          if (ends === 'terminal' || reward < -50) one.falls++
        }
        expect(saveLearner(ran)).toEqual(saveLearner(stepped))
        expect([...log.steps]).toEqual(sums.map(({ steps }) => steps))
        expect([...log.rewards]).toEqual(sums.map(({ reward }) => reward))
        expect([...log.falls]).toEqual(sums.map(({ falls }) => falls))
      }),
      { numRuns: 60 },
    )
  })

  test('are not stopped by a number of steps, as `run` is', () => {
    const settings: Settings = {
      ...{ rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0, rho: 1 },
    }
    const [whole, counted] = [beginning(worlds[0]!, settings, 3), beginning(worlds[0]!, settings, 3)]
    const log = episodeLog(20)
    runEpisodes(whole, 20, log)
    run(counted, Infinity, 20)
    expect(log.steps.reduce((sum, steps) => sum + steps, 0)).toBe(counted.steps)
  })
})

test('a fall is a step off the cliff, or into a hole; never one into a goal', () => {
  const [cliffs, holes] = worlds
  const falls = ({ isFall, names, outcome }: (typeof worlds)[number]) =>
    names.filter((_, action) => isFall.subarray(outcome[action], outcome[action + 1]).includes(1))
  // Rooms 5 and 6 are the cliff itself, where nobody stays.
  expect(falls(cliffs!).filter((name) => !/^[56]/.test(name))).toEqual(['1-down', '2-down', '4-right'])
  expect(new Set(falls(holes!).map((name) => name.split('-')[0]))).toEqual(new Set(['1', '3', '5', '7']))
})
