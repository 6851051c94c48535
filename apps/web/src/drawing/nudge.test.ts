import { expect, test } from 'vitest'
import { Nudge, type Phase } from './nudge.ts'

const up = (from: number) => from + 5

function nudged() {
  const told: [number, Phase][] = []
  return { told, nudge: new Nudge<number>((value, phase) => told.push([value, phase])) }
}

test('a key that is held adds up, and the end keeps the last value', () => {
  const { told, nudge } = nudged()
  nudge.push(10, up, 0)
  nudge.push(10, up, 500)
  nudge.letGo()
  nudge.letGo()
  expect(told).toEqual([
    [10, 'start'],
    [15, 'move'],
    [20, 'move'],
    [20, 'end'],
  ])
})

test('quick presses add up while the screen still shows the old value', () => {
  const { told, nudge } = nudged()
  nudge.push(10, up, 0)
  nudge.letGo()
  nudge.push(10, up, 10)
  nudge.letGo()
  expect(told.at(-1)).toEqual([20, 'end'])
})

test('later it goes on from what is shown', () => {
  const { told, nudge } = nudged()
  nudge.push(10, up, 0)
  nudge.letGo()
  nudge.push(10, up, 1000)
  nudge.letGo()
  expect(told.at(-1)).toEqual([15, 'end'])
})

test('a key without meaning begins nothing', () => {
  const { told, nudge } = nudged()
  expect(nudge.push(10, () => null, 0)).toBe(false)
  nudge.letGo()
  expect(told).toEqual([])
})
