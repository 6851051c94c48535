import { expect, test } from 'vitest'
import { EffortCount } from './effort.ts'

function counting() {
  let now = 0
  const effort = new EffortCount(undefined, () => now)
  return { effort, wait: (seconds: number) => (now += 1000 * seconds) }
}

test('nothing has gone into a project that nobody has touched', () => {
  expect(counting().effort.sum).toBeUndefined()
})

test('time with a hand on it counts, without pauses of half a minute', () => {
  const { effort, wait } = counting()
  for (const pause of [0, 10, 29, 31, 5]) {
    wait(pause)
    effort.touch()
  }
  expect(effort.sum?.hand).toBe(44)
})

test('a pull of a knob is one move; what the lab does by itself is no time of the child', () => {
  const { effort, wait } = counting()
  const turn = { kind: 'weight', network: 'net', from: 'a', to: 'b', after: 1, set: '' } as const
  for (const part of ['start', 'move', 'end', 'whole', 'silent'] as const) effort.change(turn, part)
  effort.hear({ kind: 'begun' })
  wait(20)
  const progress = { kind: 'progress', after: { starts: [0], hints: 0 } } as const
  effort.hear({ kind: 'changed', change: progress, back: null, joined: false })
  expect(effort.sum).toEqual({ knobs: 2, starts: 1, bumps: 0, hand: 0, computer: 0 })
})

test('bumps of all runs are added up', () => {
  const { effort } = counting()
  for (const bumps of [0, 1, 1, 3, 0, 2, 1, 2]) effort.bumped(bumps)
  expect(effort.sum?.bumps).toBe(6)
})

test('goes on from what was counted before', () => {
  const before = { knobs: 1, starts: 2, bumps: 3, hand: 4, computer: 5 }
  const effort = new EffortCount(before)
  effort.computed(0.5)
  effort.computed(1, 12)
  expect(effort.sum).toEqual({ ...before, computer: 6.5, bumps: 15 })
})
