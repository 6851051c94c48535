import { expect, test } from 'vitest'
import { noExamples, withDrive, withEarlierWishes, type Drive } from './index.ts'

const pose = { x: 1, y: 1, heading: 0 }
const recorded = [0, 6, 12, 30, 36].map((tick) => ({ tick, pose, inputs: [tick], outputs: [2 * tick] }))
const driven = (by: Drive['by']) =>
  withDrive(noExamples(['eye'], ['wheel']), { id: `${by}-1`, by, seed: 1 }, recorded).examples

test('each row gets what the hand held so many ticks later, as long as the drive goes on', () => {
  const { rows } = withEarlierWishes(driven('pad'), 12)
  expect(rows.map((row) => row.slice(-2))).toEqual([
    [0, 24],
    [6, 24],
    [12, 24],
    [30, 72],
    [36, 72],
  ])
})

test('what a program or a file showed was never late, and 0 ticks change nothing', () => {
  expect(withEarlierWishes(driven('program'), 12)).toEqual(driven('program'))
  expect(withEarlierWishes(driven('keys'), 0)).toEqual(driven('keys'))
})
