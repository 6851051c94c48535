import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { parseProject } from '@botgarten/programs'
import { afterEach, beforeAll, expect, test, vi } from 'vitest'
import type { Group } from '#drawing/commands.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { Senses } from './senses.svelte.ts'

beforeAll(() => addBlocks(learning))
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

/** The card's solution with nothing learned yet, `change`d as text, and what is written into its blocks. */
function opened(change = (text: string) => text) {
  const { card } = content.card('try-dodge')!
  const { programs, brains } = content.program('try-dodge', 'solution')!
  const project = cardProject(content.world(card.world)!, card, { programs, brains }, 'Mine')
  const text = change(JSON.stringify(project))
  const { session } = sessionOf(parseProject(text), { isCard: false })
  const written: unknown[] = []
  const senses = new Senses(session, (...one) => written.push(one))
  return { session, senses, written }
}

/** Tries for so many ticks. */
function tries({ lab }: ReturnType<typeof opened>['session'], ticks: number) {
  const draw = screen()
  lab.start()
  lab.speed = 16
  const stop = lab.run()
  while (lab.view.tick < ticks) draw()
  stop()
  lab.pause()
}

test('an edge that is pulled is written once, when the hand lets go, and never passes the other one', () => {
  const { senses, written } = opened()
  senses.pull(0, 'LOW', 22.4)
  expect(senses.edgesOf(0)).toEqual([22, 40])
  senses.pull(0, 'LOW', 90)
  expect(senses.edgesOf(0)).toEqual([39, 40])
  expect(senses.edgesOf(1)).toEqual([15, 40])
  senses.letGo()
  senses.letGo()
  expect(written).toEqual([['eyeLeft', { LOW: '39' }]])
  senses.pull(1, 'HIGH', 40)
  senses.letGo()
  expect(written).toHaveLength(1)
})

test('distance and light have edges to pull, unless both are the same; colours have none', () => {
  const edges = (change: (text: string) => string) => opened(change).senses.edgesOf(0)
  const first = (sense: string, low: string) => (text: string) =>
    text.replace('"SENSE":"DISTANCE"', `"SENSE":"${sense}"`).replace('"LOW":"15"', `"LOW":"${low}"`)
  expect(edges(first('DISTANCE', '15'))).toEqual([15, 40])
  expect(edges(first('LIGHT', '15'))).toEqual([15, 40])
  expect(edges(first('COLOUR', '15'))).toBeNull()
  expect(edges(first('DISTANCE', '40'))).toBeNull()
})

const seen = { x: -200, y: -200, width: 400, height: 400 }

test('no fan before anything is learned; then one that is only moved and turned with Bo', () => {
  const { session, senses } = opened()
  expect(senses.under({ x: 0, y: 0 }, 90, 2, seen)).toEqual([])
  tries(session, 900)
  const after = new Senses(session, () => {})
  const [one] = after.under({ x: 10, y: 10 }, 90, 2, seen)
  const [other] = after.under({ x: 20, y: 10 }, 45, 2, seen)
  expect(one).toMatchObject({ kind: 'group', x: 10, turn: 0 })
  expect(other).toMatchObject({ kind: 'group', x: 20, turn: 45 })
  expect((one as { shapes: unknown }).shapes).toEqual((other as { shapes: unknown }).shapes)
})

test('minutes that a project has saved are drawn again when it is opened', () => {
  const { card } = content.card('try-dodge')!
  const { tables, ...program } = content.program('try-dodge', 'solution')!
  const curve = [
    { pay: 12.5, bumps: 9 },
    { pay: 40, bumps: 1 },
  ]
  const saved = { ...program, tables: { try: { ...tables!['try']!, curve } } }
  const text = JSON.stringify(cardProject(content.world(card.world)!, card, saved, 'Mine'))
  const { session } = sessionOf(parseProject(text), { isCard: false })
  expect(new Senses(session, () => {}).night.shown.curve).toEqual(curve)
})

test('the cell of the last move is looked at, with its update, until another one is tapped', () => {
  const { session } = opened()
  tries(session, 900)
  const senses = new Senses(session, () => {})
  const last = senses.now!.last!
  expect(senses.cell).toEqual({ state: last.from, action: last.action })
  expect(senses.trace).toBe(last)
  const action = (last.action + 1) % 3
  senses.chosen = { state: last.from, action }
  expect(senses.trace).toBeNull()
  expect(senses.at).toBe(last.from * 3 + action)
  senses.chosen = { state: 99, action: 0 }
  expect(senses.trace).toBe(last)
})

test('the fan has the cases of the left eye on the left, whichever eye the program names first', () => {
  const oneEdge = (text: string) => text.replace('"SENSORPORT":"3","LOW":"15"', '"SENSORPORT":"3","LOW":"40"')
  const swapped = (text: string) => {
    const [left, right] = ['"SENSORPORT":"2","LOW":"15"', '"SENSORPORT":"3","LOW":"40"']
    return oneEdge(text).replace(left, '#').replace(right, left).replace('#', right)
  }
  /** Middles of its fields, from left to right. */
  const fields = (change: (text: string) => string) => {
    const { session } = opened(change)
    tries(session, 900)
    const [fan] = new Senses(session, () => {}).under({ x: 0, y: 0 }, 90, 2, seen)
    const [drawn] = (fan as Group).shapes as [Group]
    const middles = drawn.shapes.map((field) => (field as Group).shapes[0] as { x: number; y: number })
    return middles
      .map(({ x, y }) => [Math.round(x), Math.round(y)])
      .toSorted(([a = 0, b = 0], [c = 0, d = 0]) => a - c || b - d)
  }
  // Three cases of the left eye by two of the right one: six fields, and the outermost one is to the left.
  const places = fields(oneEdge)
  expect(places).toHaveLength(6)
  expect(-places[0]![0]!).toBeGreaterThan(places[5]![0]!)
  expect(fields(swapped)).toEqual(places)
})

test('a sensor that Bo does not have does not keep the fan away', () => {
  const { session } = opened((text) => text.replace('"SENSORPORT":"2","LOW"', '"SENSORPORT":"4","LOW"'))
  expect(session.config.sensors['4']).toBeUndefined()
  tries(session, 900)
  expect(new Senses(session, () => {}).fans).toBe(true)
})
