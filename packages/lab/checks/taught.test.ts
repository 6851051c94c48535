import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Drive, Row } from '@botgarten/learning/neural-network/examples'
import { starterChoice } from '@botgarten/learning/neural-network/examples'
import { cardConfig, createSimulation, paintFloor } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { worldWith } from '../testing/scene.ts'
import type { Check } from '../types.ts'
import { missing, observe, results, watch } from './checks.ts'
import { seenBy } from '../testing/seen.ts'

const world = worldWith()
const neuron = (id: string) => ({ id, activation: 'identity' as const, bias: 0 })
const given: Drive = { id: 'given', by: 'file', seed: 0 }
const row = (drive: number, tick: number, on: number, read: number, wish: number): Row => [
  ...[drive, tick, 0, 0, 0, on],
  ...[read, wish],
]

const brain = (rows: readonly Row[], more: Partial<Brain> = {}): Brain => ({
  ...{ kind: 'network', layers: [[neuron('eye')], [neuron('wheel')]], sets: {} },
  weights: { eye: { wheel: 0.5 } },
  examples: {
    version: 1,
    inputs: ['eye'],
    outputs: ['wheel'],
    drives: [given, { ...given, id: 'coach-1', by: 'coach' }],
    rows,
  },
  ...more,
})

const check = (kind: string, numbers: Check['numbers'], seconds = 1): Check => ({
  id: kind,
  kind,
  numbers,
  seconds,
})

/** What a check says of a brain: whether it passes, else what is missing. */
function said(one: Check, taught: Brain) {
  const simulation = createSimulation(world, paintFloor(world), 1)
  const watches = watch([one])
  const seen = seenBy(simulation, { taught })
  observe([one], watches, 1 / 60, seen)
  return results([one], watches)[0]!.passed || missing([one], watches, 1 / 60, seen)[0]
}

const note = (rate: number, practised: number, round = 60): Brain['practice'] => ({
  ...starterChoice,
  settings: { ...starterChoice.settings, rate },
  ...{ start: {}, round, curve: [{ round, practised, kept: null }], marks: [] },
})

describe('checks of what was shown', () => {
  const rows = [row(0, 1, 1, 10, 5), row(0, 2, 1, 20, 10), row(0, 3, 0, 30, 90), row(1, 3, 1, 40, 20)]

  it('learned: enough examples are on, and it has practised', () => {
    const learned = (rows: number) => check('learned', { rows, rounds: 1 })
    expect(said(learned(4), brain(rows))).toMatchObject({ what: 'few', facts: { seen: 3, needed: 4 } })
    expect(said(learned(3), brain(rows))).toMatchObject({ what: 'unpractised' })
    expect(said(learned(3), brain(rows, { practice: note(0.1, 0)! }))).toBe(true)
  })

  it('rowsBy: somebody has shown enough of them', () => {
    expect(said(check('rowsBy', { by: 'coach', rows: 1 }), brain(rows))).toBe(true)
    expect(said(check('rowsBy', { by: 'coach', rows: 2 }), brain(rows))).toMatchObject({ facts: { seen: 1 } })
  })

  it('clean: the wrong ones are off or gone, and most of the good ones are not', () => {
    const clean = check('clean', { drive: 'given', rows: 3, wrong: '3', found: 1, goodLost: 1 })
    expect(said(clean, brain(rows))).toBe(true)
    expect(said(clean, brain(rows.filter((one) => one[1] !== 3)))).toBe(true)
    expect(said(clean, brain([...rows, row(0, 3, 1, 30, 90)]))).toMatchObject({
      what: 'wrong',
      facts: { seen: 0, needed: 1 },
    })
    expect(said(clean, brain([]))).toMatchObject({ what: 'lost', facts: { seen: 2, most: 1 } })
  })

  it('keptBack: how far off it is on a drive, in percent; without that drive it cannot pass', () => {
    const sealed = (percent: number) => check('keptBack', { drive: 'coach-1', percent })
    expect(said(sealed(0.1), brain(rows))).toBe(true)
    const other = brain(rows, { weights: { eye: { wheel: 0.75 } } })
    // 40 · 0.75 = 30, shown was 20.
    expect(said(sealed(10.01), other)).toBe(true)
    expect(said(sealed(9.9), other)).toMatchObject({ what: 'off', facts: { most: 9.9 } })
    expect(said(check('keptBack', { drive: 'none', percent: 50 }), other)).toMatchObject({ what: 'gone' })
  })

  it('settled: it has learned, and not in small steps', () => {
    const settled = check('settled', { rate: 0.1, percent: 10 })
    expect(said(settled, brain(rows))).toMatchObject({ what: 'unpractised' })
    expect(said(settled, brain(rows, { practice: note(0.05, 0)! }))).toMatchObject({ what: 'slow' })
    expect(said(settled, brain(rows, { practice: note(0.3, 0.04)! }))).toMatchObject({ what: 'off' })
    expect(said(settled, brain(rows, { practice: note(0.1, 0.01)! }))).toBe(true)
  })
})

describe('cruises', () => {
  /** A robot that is moved by hand: cm a tick, and whether it touches. */
  function after(ticks: readonly (readonly [cm: number, touches: boolean])[]) {
    const simulation = createSimulation(
      { ...world, robots: [{ ...world.robots[0]!, config: cardConfig }] },
      paintFloor(world),
      1,
    )
    const robot = simulation.state.robots[0]!
    const one = check('cruises', { cm: 400, bumps: 1 })
    const watches = watch([one])
    ticks.forEach(([cm, touches], tick) => {
      Object.assign(robot, { x: robot.x + cm, touching: touches ? ['wall'] : [] })
      observe([one], watches, (tick + 1) / 60, seenBy(simulation))
    })
    return (
      results([one], watches)[0]!.passed || missing([one], watches, ticks.length / 60, seenBy(simulation))[0]
    )
  }
  const steps = (count: number, cm: number, touches = false) =>
    Array.from({ length: count }, () => [cm, touches] as const)

  it('is a way without more bumps than are allowed', () => {
    // 0.12 cm a tick are 432 cm a minute.
    expect(after(steps(61, 0.12))).toBe(true)
    expect(after(steps(61, 0.1))).toMatchObject({ what: 'slow', facts: { least: 400 } })
    expect(after(steps(30, 0.12))).toMatchObject({ what: 'short' })
    expect(after([...steps(30, 0.12), ...steps(20, 0.12, true), ...steps(11, 0.12)])).toBe(true)
    const twice = [...steps(30, 0.12), ...steps(5, 0.12, true), ...steps(5, 0.12), ...steps(5, 0.12, true)]
    expect(after([...twice, ...steps(20, 0.12)])).toMatchObject({
      what: 'bumped',
      facts: { bumps: 2 },
      broken: true,
    })
  })
})
