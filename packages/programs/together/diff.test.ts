import fc from 'fast-check'
import { expect, test } from 'vitest'
import { randomPrograms } from '../testing/random-programs.ts'
import type { Program } from '../types.ts'
import { apply } from './apply.ts'
import { diff } from './diff.ts'
import { beginning } from './state.ts'
import { anyOperation, sharedWith } from './testing/hands.ts'
import type { Operation, Shared } from './types.ts'

const applied = (shared: Shared, ops: readonly Operation[]): Shared => {
  const state = beginning(shared)
  ops.forEach((op, at) => apply(state, { by: 'a', n: at + 1, base: at, op }, at))
  return state.doc
}
const row = (...ids: string[]): Program => ({
  stacks: [{ x: 0, y: 0, blocks: ids.map((id) => ({ id, type: 'robActions_motorDiff_stop' })) }],
  config: { stacks: [] },
})
const kinds = (before: Program, after: Program) =>
  diff(sharedWith(before), sharedWith(after)).map(({ kind }) => kind)

test.each([
  ['nothing', row('a', 'b'), row('a', 'b'), []],
  ['a block at the end', row('a', 'b'), row('a', 'b', 'c'), ['add']],
  ['a block in between', row('a', 'b'), row('a', 'c', 'b'), ['add']],
  ['a block before all', row('a', 'b'), row('c', 'a', 'b'), ['add']],
  ['the middle one deleted', row('a', 'b', 'c'), row('a', 'c'), ['delete']],
  ['the first one deleted', row('a', 'b', 'c'), row('b', 'c'), ['delete']],
  ['two exchanged', row('a', 'b', 'c'), row('a', 'c', 'b'), ['move']],
])('%s is as many operations as it takes', (_what, before, after, expected) => {
  expect(kinds(before, after)).toEqual(expected)
})

test('a stack that was dragged is one operation', () => {
  const far = { ...row('a', 'b', 'c'), stacks: [{ ...row('a', 'b', 'c').stacks[0]!, x: 90 }] }
  expect(kinds(row('a', 'b', 'c'), far)).toEqual(['move'])
})

test('a changed field and a block that was switched off are one operation each', () => {
  const [block] = row('a').stacks[0]!.blocks
  const after: Program = {
    ...row('a'),
    stacks: [{ x: 0, y: 0, blocks: [{ ...block!, fields: { NUM: '7' }, disabled: true }] }],
  }
  const ops = diff(sharedWith(row('a')), sharedWith(after))
  expect(ops).toEqual([
    { kind: 'field', program: 'main', block: 'a', name: 'NUM', value: '7' },
    { kind: 'part', program: 'main', block: 'a', name: 'disabled', value: true },
  ])
  expect(applied(sharedWith(row('a')), ops)).toEqual(sharedWith(after))
})

test('a knob, a pose and a thing are told by where they are', () => {
  const before = sharedWith(row('a'))
  const [square, ...others] = before.world.obstacles
  const moved = { ...square!, pose: { x: 1, y: 2, heading: 0 } }
  const after = {
    ...before,
    brains: { net: { ...before.brains['net']!, weights: { left: { right: 0.75 }, up: { right: 1 } } } },
    world: { ...before.world, obstacles: [moved, ...others, { ...square!, id: 'new' }] },
  }
  const ops = diff(before, after)
  expect(ops).toEqual([
    { kind: 'knob', path: ['net', 'weights', 'left', 'right'], value: 0.75 },
    { kind: 'knob', path: ['net', 'weights', 'up', 'right'], value: 1 },
    { kind: 'thing', path: ['obstacles', square!.id, 'pose'], value: moved.pose },
    { kind: 'thing', path: ['obstacles', 'new'], value: { ...square!, id: 'new' } },
  ])
  expect(applied(before, ops)).toEqual(after)
})

test('any program becomes any other by its operations', () => {
  const step = fc.array(fc.nat(9999), { minLength: 5, maxLength: 5 })
  fc.assert(
    fc.property(randomPrograms, fc.array(step, { maxLength: 12 }), (main, steps) => {
      const before = sharedWith(main)
      const after = steps.reduce((shared, numbers, k) => {
        let at = 0
        const dice = (sides: number) => numbers[at++ % numbers.length]! % sides
        return applied(shared, [anyOperation(shared, dice, `new-${k}`)])
      }, before)
      const made = applied(before, diff(before, after))
      const stacksOf = ({ programs }: Shared) =>
        programs['main']!.stacks.map((stack) => JSON.stringify(stack.blocks)).sort()
      expect(stacksOf(made).length).toBe(stacksOf(after).length)
      expect(diff(made, after)).toEqual([])
      expect([made.brains, made.world.obstacles.length]).toEqual([after.brains, after.world.obstacles.length])
    }),
    { numRuns: 1000 },
  )
})
