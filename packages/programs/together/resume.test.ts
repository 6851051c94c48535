import fc from 'fast-check'
import { expect, test } from 'vitest'
import { randomPrograms } from '../testing/random-programs.ts'
import { diff } from './diff.ts'
import { Peer } from './peer.ts'
import { resumed } from './resume.ts'
import { anyOperation, sharedWith } from './testing/hands.ts'
import type { Entry, Shared } from './types.ts'

type Dice = (sides: number) => number
const diceOf = (numbers: readonly number[]): Dice => {
  let at = 0
  return (sides) => numbers[at++ % numbers.length]! % sides
}

/** A page of `a`, the class, and a classmate `b` who knows all of it at once. */
function play(start: Shared, steps: readonly (readonly [number, readonly number[]])[]) {
  const [page, mate] = [new Peer('a', start), new Peer('b', start)]
  const entries: Entry[] = []
  let count = 0
  const edits = (peer: Peer, dice: Dice) => peer.edit([anyOperation(peer.shared, dice, `new-${count++}`)])
  for (const [what, numbers] of steps) {
    const dice = diceOf(numbers)
    if (what < 2) edits(page, dice)
    else if (what === 2) {
      edits(mate, dice)
      entries.push(...mate.pending)
    } else {
      const sent = entries.reduce((most, { by, n }) => (by === 'a' ? Math.max(most, n) : most), 0)
      entries.push(...page.pending.filter(({ n }) => n > sent))
      page.receive(page.length, entries.slice(page.length))
    }
    mate.receive(mate.length, entries.slice(mate.length))
  }
  return { page, entries }
}

const step = fc.tuple(fc.nat(3), fc.array(fc.nat(9999), { minLength: 5, maxLength: 5 }))
const histories = fc.tuple(randomPrograms, fc.array(step, { minLength: 1, maxLength: 14 }))

/** What a page shows that was opened again. */
function opened({ page, entries }: ReturnType<typeof play>, start: Shared, saved: Shared, now: Shared) {
  const found = { author: 'a', shared: start, entries, pending: page.pending, shown: [page.length] } as const
  const again = new Peer('a', start, resumed(found, saved, now))
  again.receive(0, entries)
  return again
}

test('a page that is opened again shows what it had, and has made nothing by that', () => {
  fc.assert(
    fc.property(histories, ([main, steps]) => {
      const start = sharedWith(main)
      const played = play(start, steps)
      const { page, entries } = played
      const { shared } = page
      const again = opened(played, start, shared, shared)
      page.receive(page.length, entries.slice(page.length))
      expect(diff(page.shared, again.shared)).toEqual([])
      expect(again.pending).toEqual(page.pending)
    }),
    { numRuns: 300 },
  )
})

test('what was done before the class was heard of is there for both', () => {
  fc.assert(
    fc.property(histories, fc.integer({ min: -99, max: 99 }), ([main, steps], number) => {
      const start = sharedWith(main)
      const played = play(start, steps)
      const { shared } = played.page
      const knob = (value: number): Shared => ({
        ...shared,
        brains: { ...shared.brains, own: { ...shared.brains['net']!, weights: { left: { up: value } } } },
      })
      // The page had gone before it noted the first one; the second was done since.
      const again = opened(played, start, knob(200), knob(number))
      expect(again.shared.brains['own']!.weights).toEqual({ left: { up: number } })
    }),
    { numRuns: 300 },
  )
})

test('a program that was saved a little earlier takes nothing back of what the other one has done since', () => {
  const start = sharedWith({ stacks: [], config: { stacks: [] } })
  const entry = (n: number, name: string, value: number): Entry => ({
    ...{ by: 'b', n, base: n - 1 },
    op: { kind: 'knob', path: ['net', 'weights', 'left', name], value },
  })
  const entries = [entry(1, 'right', 0.1), entry(2, 'up', 0.2), entry(3, 'right', 0.3)]
  const early = new Peer('a', start)
  early.receive(0, entries.slice(0, 1))
  const found = { author: 'a', shared: start, entries, pending: [], shown: [1, 3] } as const
  expect(resumed(found, early.shared, early.shared)).toEqual([])
})
