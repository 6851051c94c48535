import { expect, test } from 'vitest'
import type { Exercise } from '@botgarten/learning/neural-network/examples'
import { beginExercise, prepare, withDrive, noExamples } from '@botgarten/learning/neural-network/examples'
import { practise, starter } from '@botgarten/learning/neural-network/train'
import { Host } from './host.ts'
import type { Report } from './messages.ts'

const neuron = (id: string, activation: 'identity' | 'tanh' = 'identity') => ({ id, activation, bias: 0 })
const layers = [
  [neuron('a'), neuron('b')],
  [neuron('h1', 'tanh'), neuron('h2', 'tanh')],
  [neuron('l'), neuron('r')],
]
const rows = Array.from({ length: 40 }, (_, k) => ({
  ...{ tick: 6 * k, pose: { x: k, y: 50, heading: 0 } },
  ...{ inputs: [(k * 37) % 100, (k * 53) % 100], outputs: [((k * 29) % 160) - 80, ((k * 17) % 120) - 40] },
}))
const { examples } = withDrive(noExamples(['a', 'b'], ['l', 'r']), { id: 'pad-1', by: 'pad', seed: 1 }, rows)
const exercise: Exercise = {
  ...{ id: 'net', layers, weights: {}, examples, seed: 5, keepBack: 0, from: 'knobs', mirror: null },
}
const settings = { ...starter, momentum: 0.9, batch: 7, rounds: 100 }

/** Orders carried out with a clock that goes by itself: every look at it costs `look` ms. */
function hosted(look: number, slice: number) {
  let [now, turns] = [0, 0]
  const reports: Report[] = []
  const due: { readonly at: number; readonly act: () => void }[] = []
  const host = new Host({
    now: () => (now += look),
    later: (act, ms) => due.push({ at: now + ms, act }),
    post: (report) => {
      reports.push(report)
      host.take({ kind: 'heard' })
    },
    slice,
  })
  const pass = (until = Infinity) => {
    while (due.length > 0 && now < until && turns++ < 100_000) {
      const next = due.shift()!
      now = Math.max(now, next.at)
      next.act()
    }
  }
  return { host, reports, pass, now: () => now }
}

const last = (reports: readonly Report[]) => reports.findLast((one) => one.kind === 'progress')!

const begun = (look: number, slice: number) => {
  const one = hosted(look, slice)
  one.host.take({ kind: 'begin', job: 1, exercise, settings: { ...settings, rounds: 100_000 } })
  return one
}

/** Of the whole practice in one go, by the engine alone. */
function expected(rounds: number) {
  const practice = beginExercise(prepare(exercise), { ...settings, rounds }, exercise)
  const curve = practise(practice)
  return { weights: [...practice.parameters], curve }
}

test('practice in slices of any length gives the weights and the curve of practice in one go', () => {
  const { weights, curve } = expected(60)
  for (const [look, slice] of [
    [0.01, 15],
    [1, 8],
    [5, 1],
  ] as const) {
    const { host, reports, pass } = begun(look, slice)
    host.take({ kind: 'go', until: 60, pace: Infinity })
    pass()
    const points = reports.flatMap((one) => (one.kind === 'progress' ? one.points : []))
    expect([...last(reports).now]).toEqual(weights)
    expect(points).toEqual(curve)
  }
})

test('a pause in the middle of a round shows the last whole one, and practice goes on bit for bit', () => {
  const { host, reports, pass, now } = begun(0.4, 0.1)
  host.take({ kind: 'go', until: 60, pace: Infinity })
  pass(now() + 30)
  host.take({ kind: 'stop' })
  const paused = last(reports)
  expect(paused.isGoing).toBe(false)
  expect(paused.round).toBeGreaterThan(0)
  expect(paused.round).toBeLessThan(60)
  expect([...paused.now]).toEqual(expected(paused.round).weights)
  host.take({ kind: 'go', until: 60, pace: Infinity })
  pass()
  expect([...last(reports).now]).toEqual(expected(60).weights)
})

test('at ten rounds a second a second holds ten rounds', () => {
  const { host, reports, pass, now } = begun(0.001, 15)
  host.take({ kind: 'go', until: 1000, pace: 10 })
  const began = now()
  pass(began + 1000)
  expect(last(reports).round).toBeGreaterThanOrEqual(9)
  expect(last(reports).round).toBeLessThanOrEqual(11)
})

test('an example that is only looked at changes nothing, and taken it is the same one', () => {
  const { host, reports } = begun(1, 8)
  host.take({ kind: 'peek' })
  host.take({ kind: 'peek' })
  host.take({ kind: 'step' })
  const opened = reports.filter((one) => one.kind === 'example')
  expect(opened).toHaveLength(3)
  expect(opened[1]).toEqual(opened[0])
  expect(opened[2]!.trace).toEqual(opened[0]!.trace)
})

test('every example of a round, taken one by one, is that round', () => {
  const { host, reports } = begun(1, 8)
  for (let k = 0; k < 40; k++) host.take({ kind: 'step' })
  expect(last(reports).round).toBe(1)
  expect([...last(reports).now]).toEqual(expected(1).weights)
})

test('at most twenty reports come in a second, each with the parameters of its points', () => {
  const { host, reports, pass, now } = begun(0.05, 4)
  const began = now()
  host.take({ kind: 'go', until: 3000, pace: Infinity })
  pass()
  const seconds = (now() - began) / 1000
  expect(reports.length).toBeLessThanOrEqual(20 * seconds + 2)
  for (const one of reports) {
    if (one.kind !== 'progress') continue
    expect(one.stored).toHaveLength(one.points.length * one.now.length)
  }
})

test('the first report comes as soon as a round has passed, and not before', () => {
  for (const [look, most] of [
    [0.05, 25],
    [5, 1],
  ] as const) {
    const { host, reports, pass } = begun(look, 8)
    host.take({ kind: 'go', until: 3000, pace: Infinity })
    pass()
    const [first] = reports.flatMap((one) => (one.kind === 'progress' ? [one.round] : []))
    expect(first).toBeGreaterThanOrEqual(1)
    expect(first).toBeLessThanOrEqual(most)
  }
})

test('who has not taken a report in gets none, but the last one', () => {
  const reports: Report[] = []
  let now = 0
  const due: (() => void)[] = []
  const host = new Host({
    now: () => (now += 1),
    later: (act) => due.push(act),
    post: (report) => reports.push(report),
    slice: 5,
  })
  host.take({ kind: 'begin', job: 1, exercise, settings: { ...settings, rounds: 100_000 } })
  host.take({ kind: 'go', until: 500, pace: Infinity })
  while (due.length > 0) due.shift()!()
  expect(reports).toHaveLength(2)
  expect(last(reports).round).toBe(500)
  const points = reports.flatMap((one) => (one.kind === 'progress' ? one.points : []))
  expect(points).toHaveLength(501)
})
