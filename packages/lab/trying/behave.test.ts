import { payFor, type Trial } from '@botgarten/learning/q-senses'
import { paintFloor } from '@botgarten/simulation'
import { expect, it } from 'vitest'
import { worldWith } from '../testing/scene.ts'
import { behave, beginNight, rideBy, tableOf } from './index.ts'

const world = worldWith()
const floor = paintFloor(world)
const eye = (port: '2' | '3') => ({ port, mode: 'distance' }) as const
const trial: Trial = {
  ...{
    sensors: [eye('2'), eye('3')],
    edges: [
      [15, 40],
      [15, 40],
    ],
    bump: true,
  },
  actions: [
    { left: 50, right: 50 },
    { left: -25, right: 25 },
  ],
  ...{ hold: 15, pay: [{ for: 'ahead', coins: 0.25 }], bumpEnds: false },
  ...{ alpha: 0.2, gamma: 0.9, rho: 0.2, seed: 1 },
}
const learned = () => {
  const night = beginNight(world, floor, trial)
  night.advance(3600)
  return tableOf(night.state)
}
/** A table that does one thing whatever it sees. */
const always = (action: number) => ({
  ...learned(),
  q: Array.from({ length: 20 }, (_, at) => Number(at % 2 === action)),
})

it('drives as the table drives alone, from each world, and gives the same pay for its sums as move by move', () => {
  const table = learned()
  const { behaviour, watched } = behave(table, [world, world], floor, 10)
  expect(behaviour.facts.moment).toBe(240)
  expect(behaviour.facts.way).toBeCloseTo(rideBy(table, world, floor, 10).cm, -1)
  expect(payFor(trial.pay, behaviour.facts)).toBeCloseTo(behaviour.facts.ahead / 4, 9)
  expect(watched).toHaveLength(2)
  expect(watched[0]).toEqual(watched[1])
  const coins = watched[0]!.coins.reduce((sum, one) => sum + one, 0)
  expect([watched[0]!.coins.length, watched[0]!.posesAMove]).toEqual([40, 5])
  expect(coins * 6).toBeCloseTo(payFor(trial.pay, behaviour.facts), 9)
  expect(watched[0]!.poses).toHaveLength(201)
})

it('turning on the spot is no way, one place and no bump', () => {
  const { facts, tiles, touching } = behave(always(1), [world], floor, 10).behaviour
  expect([facts.bump, tiles, touching]).toEqual([0, 1, 0])
  expect(facts.way).toBeLessThan(5)
})

it('going on and on ends at a wall, where bumps end a try', () => {
  const table = { ...always(0), bumpEnds: true }
  const { behaviour, watched } = behave(table, [world], floor, 60)
  expect(behaviour.ended).toBe(1)
  expect(watched[0]!.poses.length).toBeLessThan(60 * 20)
  const on = behave({ ...table, bumpEnds: false }, [world], floor, 60).behaviour
  expect(on.ended).toBe(0)
  expect(on.touching).toBeGreaterThan(30)
})
