import { describe, expect, test } from 'vitest'
import type { Block } from '@botgarten/blocks'
import type { Program } from '../types.ts'
import { Peer } from './peer.ts'
import { sendingSchema } from './schema.ts'
import { sharedWith } from './testing/hands.ts'
import { indexOf, inserted } from './tree.ts'
import type { Entry, Operation, Shared } from './types.ts'
import * as v from 'valibot'

const loop = (id: string, ...blocks: Block[]): Block => ({
  id,
  type: 'robControls_loopForever',
  ...(blocks.length > 0 && { statements: { DO: blocks } }),
})
const stop = (id: string): Block => ({ id, type: 'robActions_motorDiff_stop' })
const main: Program = {
  stacks: [{ x: 0, y: 0, blocks: [stop('first'), loop('loop', stop('inner')), loop('other'), stop('last')] }],
  config: { stacks: [] },
}
const program = 'main'
const start = sharedWith(main)
const remove = (block: string): Operation => ({ kind: 'delete', program, block })
const put = (block: string, place: Extract<Operation, { kind: 'move' }>['place']): Operation => ({
  kind: 'move',
  program,
  block,
  place,
})
const add = (block: Block, after: string): Operation => ({ kind: 'add', program, block, place: { after } })
const field = (block: string, value: string): Operation => ({
  kind: 'field',
  program,
  block,
  name: 'NUM',
  value,
})

/** Both do theirs without knowing of the other's; in both orders. Returns the rows of ids that come of it. */
function both(one: readonly Operation[], two: readonly Operation[]): readonly Shared[] {
  return [false, true].map((turned) => {
    const peers = [new Peer('a', start), new Peer('b', start)]
    peers[0]!.edit(one)
    peers[1]!.edit(two)
    const sent = peers.map(({ pending }) => pending)
    const log: readonly Entry[] = (turned ? sent.toReversed() : sent).flat()
    for (const peer of peers) peer.receive(0, log)
    expect(peers[0]!.shared).toEqual(peers[1]!.shared)
    return peers[0]!.shared
  })
}
const outline = (blocks: readonly Block[]): string =>
  blocks
    .map(
      ({ id, statements = {} }) =>
        id +
        Object.values(statements)
          .map((row) => `(${outline(row)})`)
          .join(''),
    )
    .join(' ')
const rows = ({ programs }: Shared) =>
  programs[program]!.stacks.map(({ blocks }) => outline(blocks)).join(' | ')

describe('two who do not know of each other', () => {
  test.each<[string, Operation, Operation, string]>([
    ['edits it', remove('inner'), field('inner', '7'), 'first loop(inner) other last'],
    ['edits what is in it', remove('loop'), field('inner', '7'), 'first loop(inner) other last'],
    ['adds into it', remove('loop'), add(stop('new'), 'inner'), 'first loop(inner new) other last'],
    ['takes out of it', remove('loop'), put('inner', { after: 'last' }), 'first other last inner'],
    ['moves it', remove('loop'), put('loop', { after: 'last' }), 'first other last loop(inner)'],
    ['adds after it', remove('loop'), add(stop('new'), 'loop'), 'first new other last'],
    [
      'adds after it where it is the last',
      remove('last'),
      add(stop('new'), 'last'),
      'first loop(inner) other new',
    ],
    ['deletes it too', remove('loop'), remove('loop'), 'first other last'],
  ])('one deletes a block, the other %s: the same in both orders', (_what, one, two, expected) => {
    expect(both([one], [two]).map(rows)).toEqual([expected, expected])
  })

  test('an edit that wins over a deletion is there', () => {
    for (const { programs } of both([remove('loop')], [field('inner', '7')]))
      expect(indexOf(programs[program]!.stacks).get('inner')!.block.fields).toEqual({ NUM: '7' })
  })

  test('two loops that are moved into each other: one move is dropped', () => {
    const into = (block: string, outer: string) => put(block, { in: outer, statement: 'DO' })
    const [one, two] = both([into('loop', 'other')], [into('other', 'loop')])
    expect([rows(one!), rows(two!)]).toEqual([
      'first other(loop(inner)) last',
      'first loop(other inner) last',
    ])
  })

  test('a block that goes with another one put into the same socket is not lost', () => {
    const socket = (id: string): Operation => ({
      kind: 'add',
      program,
      block: { id, type: 'math_number' },
      place: { in: 'loop', value: 'A' },
    })
    for (const { programs } of both([socket('x')], [socket('y')]))
      expect([...indexOf(programs[program]!.stacks).keys()]).toEqual(expect.arrayContaining(['x', 'y']))
  })

  test('a network whose knob the other turns stays, and both knobs are turned', () => {
    const knob = (to: string, value: number): Operation => ({
      kind: 'knob',
      path: ['net', 'weights', 'left', to],
      value,
    })
    for (const { brains } of both([{ kind: 'knob', path: ['net'], value: null }], [knob('right', 1)]))
      expect(brains['net']!.weights).toEqual({ left: { right: 1 } })
    for (const { brains } of both([knob('up', 1)], [knob('right', -1)]))
      expect(brains['net']!.weights['left']).toEqual({ up: 1, right: -1 })
  })
})

describe('undo', () => {
  function pair() {
    const [a, b] = [new Peer('a', start), new Peer('b', start)]
    const log: Entry[] = []
    const share = () => {
      for (const peer of [a, b]) log.push(...peer.pending.filter((one) => !log.includes(one)))
      for (const peer of [a, b]) peer.receive(peer.length, log.slice(peer.length))
    }
    return { a, b, share }
  }

  test('takes back only the own steps', () => {
    const { a, b, share } = pair()
    const backs = a.edit([remove('first')])
    share()
    b.edit([add(stop('new'), 'last')])
    share()
    const again = a.undo(backs)
    share()
    expect(rows(b.shared)).toBe('first loop(inner) other last new')
    a.undo(again)
    expect(rows(a.shared)).toBe('loop(inner) other last new')
  })

  test('leaves what the other one has gone on from', () => {
    const { a, b, share } = pair()
    const added = a.edit([add(loop('mine'), 'last')])
    const turned = a.edit([field('first', '1')])
    share()
    b.edit([
      { kind: 'add', program, block: stop('theirs'), place: { in: 'mine', statement: 'DO' } },
      field('first', '2'),
    ])
    share()
    a.undo(turned)
    a.undo(added)
    expect(rows(a.shared)).toBe('first loop(inner) other last mine(theirs)')
    expect(indexOf(a.shared.programs[program]!.stacks).get('first')!.block.fields).toEqual({ NUM: '2' })
  })

  test('what is pending is there again after the page was loaded again', () => {
    const { a } = pair()
    a.edit([add(stop('new'), 'last')])
    const again = new Peer('a', start, a.pending)
    expect(again.shared).toEqual(a.shared)
    again.edit([field('new', '1')])
    expect(again.pending.map(({ n }) => n)).toEqual([1, 2])
  })
})

describe('hostile operations', () => {
  const nested = (depth: number): Block =>
    Array.from({ length: depth }).reduce<Block>((inner, _, k) => loop(`n${k}`, inner), stop('core'))

  test.each<[string, Operation]>([
    ['a knob that is no number', { kind: 'knob', path: ['net', 'weights', 'left', 'right'], value: 'a lot' }],
    ['a network that is none', { kind: 'knob', path: ['net'], value: { kind: 'network' } }],
    ['a thing that is none', { kind: 'thing', path: ['obstacles', 'x'], value: { id: 'x' } }],
    ['a world without its robots', { kind: 'thing', path: ['robots'], value: [] }],
    [
      'a robot that is deleted last',
      { kind: 'thing', path: ['robots', start.world.robots[0]!.id], value: null },
    ],
    ['the program of a robot', { kind: 'program', program, value: null }],
    ['blocks that are too deep', { kind: 'add', program, block: nested(200), place: { after: 'last' } }],
    ['a part that is none', { kind: 'part', program, block: 'first', name: 'flags', value: 7 }],
    ['a block of no program', { kind: 'delete', program: 'nobody', block: 'first' }],
  ])('%s changes nothing', (_what, op) => {
    const peer = new Peer('a', start)
    peer.edit([op])
    expect(peer.shared).toEqual(start)
  })

  test.each([
    ['too many', { ops: Array.from({ length: 501 }, (_, n) => ({ n: n + 1, base: 0, op: remove('x') })) }],
    ['none', { ops: [] }],
    [
      'a reserved name',
      JSON.parse('{"ops":[{"n":1,"base":0,"op":{"kind":"knob","path":["__proto__"],"value":1}}]}'),
    ],
    [
      'a reserved key',
      JSON.parse('{"ops":[{"n":1,"base":0,"op":{"kind":"knob","path":["x"],"value":{"__proto__":1}}}]}'),
    ],
    ['an unknown kind', { ops: [{ n: 1, base: 0, op: { kind: 'run' } }] }],
    [
      'a place that is two',
      {
        ops: [
          { n: 1, base: 0, op: { kind: 'move', program, block: 'x', place: { after: 'y', x: 1, y: 1 } } },
        ],
      },
    ],
    [
      'a place without end',
      { ops: [{ n: 1, base: 0, op: { kind: 'move', program, block: 'x', place: { x: Infinity, y: 1 } } }] },
    ],
    ['what is nested a thousand times', { ops: [{ n: 1, base: 0, op: add(nested(1000), 'x') }] }],
  ])('%s is refused', (_what, sending) => {
    expect(v.is(sendingSchema, sending)).toBe(false)
  })

  test.each<Operation>([
    add(stop('new'), 'last'),
    { kind: 'move', program, block: 'x', place: { x: 1, y: 1 } },
    remove('x'),
    field('x', '1'),
    { kind: 'field', program, block: 'x', name: 'NUM', value: null },
    { kind: 'part', program, block: 'x', name: 'flags', value: [] },
    { kind: 'knob', path: ['net', 'weights', 'left', 'right'], value: 1 },
    { kind: 'thing', path: ['obstacles', 'x'], value: null },
    { kind: 'program', program, value: null },
  ])('an operation of the kind $kind is accepted', (op) => {
    expect(v.is(sendingSchema, { ops: [{ n: 1, base: 0, op }] })).toBe(true)
  })

  test('an honest one is taken', () => {
    const ops = [{ n: 1, base: 0, op: add(stop('new'), 'last') }]
    expect(v.parse(sendingSchema, { ops })).toEqual({ ops })
  })
})

test('a block whose place was deleted is put below all stacks', () => {
  const stacks = [0, 300].map((y) => ({ x: 0, y, blocks: [stop(`at${y}`)] }))
  const loose = inserted(stacks, stop('loose'), { after: 'gone' }).at(-1)!
  expect(loose.blocks).toEqual([stop('loose')])
  expect(loose.y).toBeGreaterThan(300)
})
