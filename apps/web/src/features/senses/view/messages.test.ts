import type { TableBrain, TryTrace } from '@botgarten/learning/q-senses'
import { cardConfig, COLOURS } from '@botgarten/simulation'
import { describe, expect, test } from 'vitest'
import { m } from '#words/message.ts'
import { actionName, bucketNames, fixed, sensorNames, sizeSentence, sumOf } from './messages.ts'

const eye = (port: '1' | '2' | '3' | '4') => ({ port, mode: 'distance' }) as const
const trace: TryTrace = {
  ...{ t: 9, from: 8, action: 0, decision: 'exploit', to: 8, reward: 1.1 },
  ...{ before: 9.58, bestNext: 9.58, after: 9.6084, alpha: 0.2, ends: false },
}

describe('the update stands there with its numbers', () => {
  test('as in the picture', () => {
    expect(sumOf(trace, 0.9)).toBe('9.58 + 0.2 × (1.10 + 0.9 × 9.58 − 9.58) =')
  })

  test('and comes out: what is shown is what was learned, within the places that are shown', () => {
    const { before, alpha, reward, bestNext, after } = trace
    expect(before + alpha * (reward + 0.9 * bestNext - before)).toBeCloseTo(after, 12)
  })

  test('numbers below 0 behind a sign are in brackets', () => {
    const sum = sumOf({ ...trace, before: -1.2, bestNext: -0.5, reward: -5 }, 0.9)
    expect(sum).toBe('−1.20 + 0.2 × (−5.00 + 0.9 × (−0.50) − (−1.20)) =')
  })
})

test('a number has always as many places, a true minus, and no minus before 0', () => {
  expect([3, -1.25, -0.01].map((value) => fixed(value, 1))).toEqual(['3.0', '−1.3', '0.0'])
})

test('columns are named by where the eyes are, two alike by their ports too', () => {
  expect(sensorNames({ sensors: [eye('2'), eye('3')] }, cardConfig)).toEqual([
    m['senses.eye.left'](),
    m['senses.eye.right'](),
  ])
  const [one, other] = sensorNames({ sensors: [eye('2'), eye('2')] }, cardConfig)
  expect(one).toBe(m['senses.atPort']({ name: m['senses.eye.left'](), port: '2' }))
  expect(other).toBe(one)
})

test('rows are named by their buckets: near, middle, far; dark to bright; colours; a bump', () => {
  const table = {
    sensors: [
      eye('2'),
      { port: '1', mode: 'light' },
      { port: '1', mode: 'colour' },
      { port: '4', mode: 'touch' },
    ],
    edges: [[15, 40], [30], [1, 2, 3, 4, 5, 6, 7], [1]],
  } as unknown as TableBrain
  const green = Object.values(COLOURS).indexOf('#00642E')
  expect(bucketNames(table, { buckets: [1, 1, green, 0], cells: [] })).toEqual([
    ...[m['senses.between'](), m['senses.bright']()],
    m['choice.green'](),
    m['senses.free'](),
  ])
  expect(bucketNames(table, { buckets: null, cells: [] })).toEqual([m['senses.bump']()])
})

test('moves are named by their chips, those of one’s own by their wheels and lamp', () => {
  expect(actionName({ left: -25, right: 25 })).toBe(m['choice.tryLeft']())
  const name = m['senses.wheels']({ left: '60', right: '30' })
  expect(actionName({ left: 60, right: 30 })).toBe(name)
  expect(actionName({ left: 60, right: 30, lamp: 'off' })).toBe(
    m['senses.lamp']({ name, lamp: m['choice.tryDark']() }),
  )
})

test('how many cases there are is said as a product', () => {
  expect(sizeSentence({ buckets: [3, 3], bump: true, states: 10 })).toBe(
    m['senses.sizeBump']({ product: '3 × 3', states: 10 }),
  )
})
