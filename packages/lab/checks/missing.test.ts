import { cardConfig, createSimulation, paintFloor, type World } from '@botgarten/simulation'
import { describe, expect, it, test } from 'vitest'
import type { Check } from '../types.ts'
import { missing, observe, watch } from './checks.ts'
import { kinds } from './kinds.ts'
import { seenBy } from '../testing/seen.ts'

const world: World = {
  size: { width: 400, height: 400 },
  floor: { colour: '#FFFFFF' },
  areas: [
    {
      id: 'green',
      shape: { kind: 'rectangle', width: 400, height: 40 },
      pose: { x: 200, y: 120, heading: 0 },
      colour: '#00642E',
    },
    {
      id: 'unnamed',
      shape: { kind: 'rectangle', width: 40, height: 40 },
      pose: { x: 40, y: 340, heading: 0 },
      colour: '#FF99CC',
    },
  ],
  lines: [],
  obstacles: [
    {
      id: 'square',
      shape: { kind: 'rectangle', width: 50, height: 50 },
      pose: { x: 200, y: 200, heading: 0 },
      fixed: true,
      colour: '#0057A6',
    },
  ],
  robots: [
    { id: 'bo', pose: { x: 200, y: 60, heading: 90 }, program: 'main', brain: '', config: cardConfig },
  ],
}

/** Every number that a kind needs, as a card would give them. */
const numbers = {
  ...{ x: 200, y: 110, cm: 8, after: '', obstacle: 'square', until: '', percent: 3, near: 60, far: 80 },
  ...{ colour: '#00642E', lamp: 'green', others: '#FFFFFF', least: 50, most: 100, light: 15, hertz: 150 },
  ...{
    rows: 4,
    rounds: 1,
    brains: 4,
    bumps: 0,
    by: 'coach',
    drive: 'given',
    wrong: '3',
    found: 1,
    goodLost: 0,
    rate: 0.1,
  },
  ...{ gates: '100 60, 300 60, 200 350', laps: 1, points: '200 60, 60 160', kinds: 3, letters: 0 },
  ...{ animal: 'gazer', cheats: 'cm 0 60' },
}
const checkOf = (kind: string, other: object = {}): Check => ({
  ...{ id: kind, kind, seconds: 1 },
  numbers: { ...numbers, ...other },
})

/** Looks at a robot that somebody has put there, facing up; says what is missing then. */
function after(checks: readonly Check[], y: number, seconds: number, robot: object = {}, percent = 0) {
  const simulation = createSimulation(world, paintFloor(world), 1)
  const watches = watch(checks)
  simulation.place('bo', { x: 200, y, heading: 90 })
  const state = simulation.state.robots[0]!
  Object.assign(state, robot)
  state.motors.B.percent = state.motors.C.percent = percent
  for (let tick = 1; tick <= seconds * 60; tick++) observe(checks, watches, tick / 60, seenBy(simulation))
  return missing(checks, watches, seconds, seenBy(simulation))
}

describe.each(Object.keys(kinds))('the kind %s', (kind) => {
  it('says what is missing in one of the ways it names, before anything was seen too', () => {
    const [nothing] = after([checkOf(kind)], 60, 0)
    expect(nothing).toMatchObject({ check: kind, kind })
    expect(kinds[kind]!.lacks).toContain(nothing!.what)
    const [some] = after([checkOf(kind)], 60, 0.5)
    if (some) expect(kinds[kind]!.lacks).toContain(some.what)
  })
})

describe('what is missing', () => {
  // The robot looks up: the point at y = 110 lies ahead of 60 and behind 150. Its front is 10 cm before its axle, the
  // square's near side at 175.
  test.each([
    [60, 'before', 50],
    [150, 'beyond', 40],
  ])('arrives: standing at %i it is %s the point, by %i cm', (y, what, away) => {
    const [one] = after([checkOf('arrives')], y, 2)
    expect(one).toMatchObject({ what, gap: { from: { x: 200, y }, to: { x: 200, y: 110 } } })
    expect(one!.facts['away']).toBeCloseTo(away, 6)
  })

  it('arrives: beside it, where it is neither ahead nor behind', () => {
    expect(after([checkOf('arrives', { x: 300, y: 60 })], 60, 2)[0]).toMatchObject({
      what: 'beside',
      facts: { away: 100 },
    })
  })

  it('arrives: there, and still driving', () => {
    expect(after([checkOf('arrives')], 110, 2, {}, 30)[0]).toMatchObject({ what: 'moving' })
  })

  it('stays: the gap from its front to the outline', () => {
    const [one] = after([checkOf('stays')], 60, 2)
    expect(one).toMatchObject({ what: 'far', facts: { thing: 'square' } })
    expect(one!.facts['away']).toBeCloseTo(105, 6)
    expect(one!.gap!.from.y).toBeCloseTo(70, 6)
    expect(one!.gap!.to.y).toBeCloseTo(175, 6)
  })

  it('laps: stands where the sensor names no colour, after it has driven', () => {
    const simulation = createSimulation(world, paintFloor(world), 1)
    const checks = [checkOf('laps')]
    const watches = watch(checks)
    const { motors } = simulation.state.robots[0]!
    let tick = 0
    const missed = (x: number, percent: number) => {
      simulation.place('bo', { x, y: 340, heading: 90 })
      motors.B.percent = motors.C.percent = percent
      observe(checks, watches, ++tick / 60, seenBy(simulation))
      return missing(checks, watches, tick / 60, seenBy(simulation))[0]!.what
    }
    expect([missed(40, 0), missed(40, 30), missed(40, 0), missed(200, 0), missed(40, 30)]).toEqual([
      ...['some', 'some', 'blind', 'some', 'some'],
    ])
  })

  it('near: the nearest it ever came', () => {
    expect(after([checkOf('near')], 100, 1)[0]!.facts['away']).toBeCloseTo(65, 6)
  })

  it('led: how the lamp shone where the colour was', () => {
    const red = after([checkOf('led')], 115, 2, { led: 'red' })
    expect(red[0]).toMatchObject({ what: 'other', facts: { shone: 'red', lamp: 'green' } })
    expect(after([checkOf('led')], 115, 2, { led: null })[0]).toMatchObject({ what: 'dark' })
    expect(after([checkOf('led')], 60, 2, { led: 'green' })[0]).toMatchObject({ what: 'unseen' })
    expect(after([checkOf('led')], 115, 0.5, { led: 'green' })[0]).toMatchObject({
      what: 'short',
      facts: { seconds: 0.5, needed: 1 },
    })
    expect(after([checkOf('led')], 115, 1, { led: 'green' })).toEqual([])
  })

  it('speedOn: how fast it was there, and which limit that breaks', () => {
    const slow = after([checkOf('speedOn')], 115, 2, {}, 30)
    expect(slow[0]).toMatchObject({ what: 'slow', facts: { speed: 30, least: 50 } })
    const fast = after([checkOf('speedOn', { least: 0, most: 10 })], 115, 2, {}, 30)
    expect(fast[0]).toMatchObject({ what: 'fast', facts: { speed: 30, most: 10 } })
  })

  it('visits: how many places, and how far the next one is', () => {
    const [one] = after([checkOf('visits', { points: '200 60, 200 160' })], 60, 1)
    expect(one).toMatchObject({ facts: { seen: 1, all: 2, away: 100 } })
  })

  it('comes first where something was broken', () => {
    const checks = [checkOf('near'), checkOf('neverTouches')]
    const touched = after(checks, 60, 2, { touching: ['square'] })
    expect(touched.map(({ what }) => what)).toEqual(['touched', 'far'])
    expect(touched[0]!.facts['seconds']).toBeCloseTo(1 / 60, 6)
  })
})
